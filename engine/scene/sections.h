// The sections of a scene, each read into the model. They trust the schema for the shape of the document and check what
// it cannot: values, units, names and places. All throw InputError (without a file).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/builder/scheme.h"
#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"
#include "engine/scene/given_blocks.h"
#include "engine/scene/plain_lines.h"
#include "engine/scene/record_files.h"
#include "engine/scene/stress_field.h"

namespace dda {

Scheme read_scheme(const Field& scene);
void read_materials(const Field& scene, Model& model);
// Drawings, which may name joints, are looked for relative to `folder`. `lines` stand for those of rock. Returns
// remarks, sentences on joints that no line of a drawing uses.
std::vector<std::string> read_joints(const Field& scene, const Scheme& scheme, const std::filesystem::path& folder,
                                     const std::vector<PlainLines>& lines, Model& model);

// Says of each block its group (its generator's name, or a polygon's own) and whether it states its initial stress.
struct BlockFacts {
  std::vector<std::string> groups;
  std::vector<bool> own_stress;
  std::vector<std::string> remarks;  // on cutting rock, see cut_remarks.h
};

// Drawings are looked for relative to `folder`. Entries for which blocks are given are not read for theirs, and `lines`
// stand for those of rock.
BlockFacts read_blocks(const Field& scene, const std::filesystem::path& folder, const std::vector<GivenBlocks>& given,
                       const std::vector<PlainLines>& lines, Model& model);
void read_joint_pairs(const Field& scene, const std::vector<std::string>& groups, Model& model);
void read_gravity(const Field& scene, Model& model);

// These need the blocks complete, as finish_model leaves them, and the stages.
// Says which blocks got a stress.
std::vector<int> read_initial_fields(const Field& scene, const std::vector<std::string>& groups, Model& model);
void read_joint_lines(const Field& scene, const GroundPlan& plan, Model& model);
void read_loads(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                const StressField& stresses, RecordFiles& records, Model& model);
void read_supports(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                   RecordFiles& records, Model& model);
void read_bolts(const Field& scene, const GroundPlan& plan, Model& model);
// `openings`: of all rock.
void read_linings(const Field& scene, const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings,
                  Model& model);
void read_viscous_boundaries(const Field& scene, const GroundPlan& plan, const StressField& stresses, Model& model);
void read_measurements(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                       Model& model);

// `openings`: of all rock.
void read_peaks(const Field& scene, const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings,
                Model& model);

// What a stage changes of the rock that the model has after its stages so far.
RockOfStage read_rock_changes(const Field& step, const Model& model);
void read_stages(const Field& scene, const Scheme& scheme, const std::vector<std::string>& groups, Model& model);

}  // namespace dda
