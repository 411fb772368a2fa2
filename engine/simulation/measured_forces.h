// Forces that measurements add up: of supports and held blocks, between two sets of blocks, and across a line.
//
// All of them are what the engine's own balance M a = loads + weight - internal forces is made of: the forces conjugate
// to the translation and turn of blocks. So sums over free bodies balance to round-off, whatever the joints. Dampers of
// joints and supports are in them: material damping with the velocities of now, dashpots of contacts with the mean of
// the last step.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/measurement.h"

namespace dda {

struct BlockSystem;

// x and y, N, and moment, N m counter-clockwise, about a stated point; per m of thickness.
using ForceAndMoment = Vec3;

// What the supports and held blocks of the measurement exert on the others: a held block gives what it takes to hold it
// against contacts, bolts and loads; it has no weight and no inertia of its own.
ForceAndMoment reaction(const BlockSystem& system, const Measurement& measurement);

// The contacts on which one side of a measurement acts on the other: those between its `blocks` and `others` (drawn on
// its line, where it has one), or across its line.
struct Cut {
  // Indices, where interfaces stay; where they are found anew as blocks move, or leave with blocks that are removed,
  // they are picked out each time.
  std::optional<std::vector<std::size_t>> interfaces;
};

Cut make_cut(const BlockSystem& system, const Measurement& measurement);

// True when some contact that there is now is cut.
bool cuts_something(const BlockSystem& system, const Measurement& measurement);

// x, y, normal (tension positive) and shear, N per m of thickness: what `others` of the measurement exert on `blocks`.
// Normal and shear are in each contact's own axes, which turn with it; a positive shear pulls the first side to the
// left, seen looking out of it.
Eigen::Vector4d contact_force(const BlockSystem& system, const Measurement& measurement, const Cut& cut);

// What the material on the right of the measurement's line exerts on that on its left, by contacts and bolts. Blocks
// are on the side on which their centroid was drawn; the cut runs along the joints between the two, as far as the
// middle of a joint lies beside the line.
ForceAndMoment resultant(const BlockSystem& system, const Measurement& measurement, const Cut& cut);

// True of the three above.
bool is_of_forces(const Measurement& measurement);

// That of them which is measured, as histories_of() lists its values.
void write_forces(const BlockSystem& system, const Measurement& measurement, const Cut& cut, std::span<double> values);

// Adds what acts at the end of a part of a step, `dt` long (s), to the forces of that step.
void note_part(double dt, BlockSystem& system);

}  // namespace dda
