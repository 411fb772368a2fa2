// The sections of a scene, each read into the model. They trust the schema for the shape of the document and check what
// it cannot: values, units, names and places. All throw InputError (without a file).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/scene/field.h"
#include "engine/scene/ground_plan.h"
#include "engine/scene/record_files.h"
#include "engine/scene/scheme.h"

namespace dda {

Scheme read_scheme(const Field& scene);
void read_materials(const Field& scene, Model& model);
void read_joints(const Field& scene, const Scheme& scheme, Model& model);

// Returns the group of each block: the name of its generator, of a polygon its own. Drawings are looked for relative to
// `folder`.
std::vector<std::string> read_blocks(const Field& scene, const std::filesystem::path& folder, Model& model);
void read_joint_pairs(const Field& scene, const std::vector<std::string>& groups, Model& model);
void read_gravity(const Field& scene, Model& model);

// These need the blocks complete, as finish_model leaves them, and the stages.
void read_initial_fields(const Field& scene, const std::vector<std::string>& groups, Model& model);
void read_joint_lines(const Field& scene, const GroundPlan& plan, Model& model);
void read_loads(const Field& scene, const GroundPlan& plan, RecordFiles& records, Model& model);
void read_supports(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                   RecordFiles& records, Model& model);
void read_bolts(const Field& scene, const GroundPlan& plan, Model& model);
void read_viscous_boundaries(const Field& scene, const GroundPlan& plan, Model& model);
void read_measurements(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                       Model& model);

void read_stages(const Field& scene, const Scheme& scheme, Model& model);

}  // namespace dda
