// What changes from step to step, in contiguous per-block arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

struct State {
  double time = 0;  // s
  std::int64_t step = 0;
  std::vector<Vec6> displacement;  // sums of the step increments
  std::vector<Vec6> velocity;      // time derivatives of the six unknowns
  std::vector<Vec6> acceleration;
  std::vector<Vec3> stress;       // Pa, Cauchy stress in the global frame, tension positive
  std::vector<Mat2> deformation;  // current offset from the centroid = deformation * reference offset
};

// Calls `visit(memory, bytes)` for every part of a state, to write it or to read it back; a member added to State
// breaks the first line.
template <typename AnyState, typename Visitor>
void visit_memory(AnyState& state, const Visitor& visit) {
  auto& [time, step, displacement, velocity, acceleration, stress, deformation] = state;
  visit(&time, sizeof time);
  visit(&step, sizeof step);
  const auto visit_array = [&](auto& values) {
    if (!values.empty()) visit(values.front().data(), values.size() * sizeof values.front());
  };
  visit_array(displacement);
  visit_array(velocity);
  visit_array(acceleration);
  visit_array(stress);
  visit_array(deformation);
}

State initial_state(const Model& model);

// Local places count from Model::origin. What is computed of where blocks are now - gaps, arms, boxes - is computed of
// these: in coordinates of the drawing a scene that lies far from their origin would know its places to fewer digits
// than its springs answer to (ADR 102).
inline Vec2 local_place(const Model& model, const Vec2& drawn) { return drawn - model.origin; }

// Where the centroid of a block, and its material point that was at `reference`, are now.
Vec2 local_centroid(const Model& model, const State& state, int block);
Vec2 local_position(const Model& model, const State& state, int block, const Vec2& reference);

// The same in coordinates of the drawing, for files, messages and what is told to 1e-3 of a block.
Vec2 current_centroid(const Model& model, const State& state, int block);
Vec2 current_position(const Model& model, const State& state, int block, const Vec2& reference);

// Displacement since the start and velocity of the material point that was at `reference`. The displacement keeps its
// precision far from the origin.
Vec2 point_displacement(const Model& model, const State& state, int block, const Vec2& reference);
Vec2 point_velocity(const Model& model, const State& state, int block, const Vec2& reference);

}  // namespace dda
