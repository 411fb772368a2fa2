// Forces that measurements add up: of supports and held blocks, between two sets of blocks, and across a line.
//
// All of them are what the engine's own balance M a = loads + weight - internal forces is made of: the forces conjugate
// to the translation and turn of blocks. So sums over free bodies balance to round-off, whatever the joints. Dampers of
// joints and supports are in them: material damping with the velocities of now, dashpots of contacts with the mean of
// the last step.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/model/measurement.h"
#include "engine/simulation/simulation.h"

namespace dda {

// x and y, N, and moment, N m counter-clockwise, about a stated point; per m of thickness.
using ForceAndMoment = Vec3;

// What the supports and held blocks of the measurement exert on the others: a held block gives what it takes to hold it
// against contacts, bolts and loads; it has no weight and no inertia of its own.
ForceAndMoment reaction(const Simulation& simulation, const Measurement& measurement);

// The contacts on which one side of a measurement acts on the other: those between its `blocks` and `others` (drawn on
// its line, where it has one), or across its line.
struct Cut {
  // Indices, where interfaces stay; where they are found anew as blocks move, or leave with blocks that are removed,
  // they are picked out each time.
  std::optional<std::vector<std::size_t>> interfaces;
};

Cut make_cut(const Simulation& simulation, const Measurement& measurement);

// True when some contact that there is now is cut.
bool cuts_something(const Simulation& simulation, const Measurement& measurement);

// x, y, normal (tension positive) and shear, N per m of thickness: what `others` of the measurement exert on `blocks`.
// Normal and shear are in each contact's own axes, which turn with it; a positive shear pulls the first side to the
// left, seen looking out of it.
Eigen::Vector4d contact_force(const Simulation& simulation, const Measurement& measurement, const Cut& cut);

// What the material on the right of the measurement's line exerts on that on its left, by contacts and bolts. Blocks
// are on the side on which their centroid was drawn; the cut runs along the joints between the two, as far as the
// middle of a joint lies beside the line.
ForceAndMoment resultant(const Simulation& simulation, const Measurement& measurement, const Cut& cut);

}  // namespace dda
