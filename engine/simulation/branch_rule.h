// What two scenes must have in common so that one can go on from a state of the other: all that gives the numbers of a
// state their meaning.
//
// - blocks: outlines, materials and stress at the start, and which of them are held;
// - joints: where they lie, their laws, stiffnesses and dampers, and which of them have any strength;
// - stages: those that are done, in all respects;
// - free-field sides with their edges.
//
// All else may differ: strengths, gravity, loads, supports, bolts, absorbing edges, measurements, later stages.
#pragma once

#include <cstddef>

#include "engine/model/model.h"

namespace dda {

// Throws InputError (without a file) naming the first of these that differs in `branch`. `stages`: how many are done.
void expect_same_past(const Model& settled, const Model& branch, std::size_t stages);

bool have_same_viscous_edges(const Model& a, const Model& b);

}  // namespace dda
