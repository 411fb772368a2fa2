// What the rock is in each stage: elasticity and density of its materials, and strength and springs of its joints can
// change when a stage begins (loosened, improved or soaked rock, concrete that hardens, joints that weather or get
// wet). Blocks can come in.
//
// Materials and joints keep their names, places and laws, and penalties go by the materials of the start; what may
// change of them is said in check_rock_changes.cpp. A stage that changes nothing has empty tables.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/material.h"

namespace dda {

struct Model;

struct RockOfStage {
  std::vector<Material> materials;    // all of the model's, from the start of the stage on; empty: as before
  std::vector<JointMaterial> joints;  // the same
  std::vector<int> added = {};        // blocks that come in at the start of the stage, as drawn and free of stress
};

// Those in force in a stage. Of a finished model, whose first stage then has what the model began with.
const std::vector<Material>& materials_in(const Model& model, std::size_t stage);
const std::vector<JointMaterial>& joints_in(const Model& model, std::size_t stage);

bool have_same_moduli(const Material& a, const Material& b);
bool have_same_density(const Material& a, const Material& b);
bool have_same_strength(const JointMaterial& a, const JointMaterial& b);
// Springs as a joint gives them, and the dashpots beside them.
bool have_same_springs(const JointMaterial& a, const JointMaterial& b);

// Whether springs of a joint go by the length for which each stands, and so which contacts of a face have one.
bool springs_go_by_length(const JointMaterial& joint);

bool changes_materials(const Model& model);
bool changes_joints(const Model& model);
bool changes_springs(const Model& model);

// Gives the first stage the tables of the model where a later one has others, so that a model whose rock has changed in
// a run still knows what it was.
void keep_rock_at_start(Model& model);

// The model as it was before any stage began.
Model with_rock_at_start(Model model);

}  // namespace dda
