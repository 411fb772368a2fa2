// Where a load or a prescribed motion acts: at a point, along an edge, or on all of a block that is held.
#pragma once

#include "engine/geometry/segment.h"
#include "engine/model/model.h"

namespace dda {

struct ActingPlace {
  int block = 0;
  Segment face = {Vec2::Zero(), Vec2::Zero()};  // m; a point where both its ends are one
  bool all_of_it = false;                       // the block, with its whole outline
};

inline ActingPlace place_of(const EdgeLoad& load) { return {load.block, {load.from, load.to}}; }
inline ActingPlace place_of(const PointLoad& load) { return {load.block, {load.point, load.point}}; }
inline ActingPlace place_of(const PointSupport& support) { return {support.block, {support.point, support.point}}; }
inline ActingPlace place_of(const HeldBlock& held) { return {.block = held.block, .all_of_it = true}; }

// Pa, in x and y: what the loaded face of a block bears of the stress that the block begins with.
Vec2 traction_at_start(const Model& model, const EdgeLoad& load);

// m, from the nearest of it.
double distance(const Model& model, const ActingPlace& place, const Vec2& point);

}  // namespace dda
