// Rock in a scene: read as a plan, cut, and made into blocks and joint lines of the model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/builder/generators.h"
#include "engine/cutting/cut_rock.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"
#include "engine/scene/plain_lines.h"

namespace dda {

// A joint set as remarks name it.
struct NamedSet {
  std::string name;
  std::string origin;  // of its traces in the plan
};

struct Rock {
  std::string path;  // of the scene's entry
  RockPlan plan;
  CutOptions options;
  BlockGroup group;
  std::vector<NamedSet> joint_sets;
  std::vector<std::string> remarks;  // on its drawing
};

// `field` is {"boundary": ..., ...}; a drawing is looked for relative to `folder`; `lines` stand for those of the field
// if they are its; the model has its materials and joints.
Rock read_rock(const Field& field, const std::filesystem::path& folder, const std::vector<PlainLines>& lines,
               const Model& model);

// Cuts the plan, and remarks on joint sets that have no joint in the rock. Errors name fields of the scene.
CutRock cut(const Rock& rock);

// Name of the group of a block: that a drawing of blocks gives it, that of its opening, else that of the rock.
const std::string& group_name(const Rock& rock, const CutBlock& block);

// Appends the blocks, "GROUP 1", "GROUP 2", ... from left to right in each group, the group of each, and a joint line
// for every run of a joint that is not the default one.
void append_rock(const Rock& rock, const CutRock& cut, Model& model, std::vector<std::string>& groups);

}  // namespace dda
