// Which tables of materials and joints are in force in a stage, and what differs between them.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/material.h"
#include "engine/model/model.h"

namespace dda {

// Those in force in a stage of a model that is finished: its first stage then has what the model began with.
const std::vector<Material>& materials_in(const Model& model, std::size_t stage);
const std::vector<JointMaterial>& joints_in(const Model& model, std::size_t stage);

bool have_same_moduli(const Material& a, const Material& b);
bool have_same_density(const Material& a, const Material& b);
bool have_same_strength(const JointMaterial& a, const JointMaterial& b);
// Springs as a joint gives them, and the dashpots beside them.
bool have_same_springs(const JointMaterial& a, const JointMaterial& b);

// Whether springs of a joint go by the length for which each stands, and so which contacts of a face have one.
bool springs_go_by_length(const JointMaterial& joint);

bool changes_springs(const Model& model);

// Gives the first stage the tables of the model where a later one has others, so that a model whose rock has changed in
// a run still knows what it was.
void keep_rock_at_start(Model& model);

// The model as it was before any stage began.
Model with_rock_at_start(Model model);

}  // namespace dda
