// What all kinds of blocks in a scene have in common: group, material, state at the start.
#pragma once

#include <string>

#include "engine/builder/generators.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

int material_named(const Field& name, const Model& model);

// name, material, initial_stress, initial_velocity and initial_spin of `field`.
BlockGroup read_group(const Field& field, std::string default_name, const Model& model);

// A block with the properties of the group and no shape yet.
Block block_of(const BlockGroup& group, std::string name);

Ring read_ring(const Field& field);

}  // namespace dda
