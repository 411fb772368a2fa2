// A grid of blocks with free-field sides on a base that is shaken, for tests.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "engine/simulation/simulation_models.h"

namespace dda::free_field {

inline constexpr int columns = 5;
inline constexpr int rows = 6;

// Viscous edges along both sides, with a free field.
inline void add_sides(int first_stage, Model& model) {
  for (const bool right : {false, true}) {
    FreeFieldSide side;
    side.outward = right ? 1 : -1;
    for (int row = 0; row < rows; ++row) {
      const double x = right ? columns : 0;
      const int block = row * columns + (right ? columns - 1 : 0);
      side.viscous_edges.push_back(static_cast<int>(model.viscous_edges.size()));
      model.viscous_edges.push_back({block, {x, 1.0 * row}, {x, row + 1.0}, 1.2e7, 7e6, first_stage});
    }
    model.free_field_sides.push_back(side);
  }
}

// Rollers of this stiffness (N/m) hold both sides in the first stage.
inline void hold_sides_first(double stiffness, Model& model) {
  for (int row = 0; row < rows; ++row)
    for (const bool right : {false, true})
      for (const double y : {row + 0.0, row + 1.0}) {
        PointSupport& roller = model.supports.emplace_back();
        roller.block = row * columns + (right ? columns - 1 : 0);
        roller.point = {right ? columns : 0, y};
        roller.stiffness = stiffness;
        roller.holds_y = false;
        roller.last_stage = 0;
      }
}

// Blocks of 1 m on a base that jerks along x and y, both sides free; the upper half lighter and softer.
inline Model shaken_grid(const JointMaterial& joint) {
  Model model;
  model.materials = {rock(), rock()};
  model.materials[1].young /= 2;
  model.materials[1].density *= 0.8;
  model.joints = {joint};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      model.blocks.push_back(rectangle(fmt::format("{}.{}", row, column), column, row, 1, 1));
      model.blocks.back().material = row < rows / 2 ? 0 : 1;
    }
  model.blocks.push_back(rectangle("base", 0, -1, columns, 1));
  HeldBlock base;
  base.block = rows * columns;
  base.amplitude = {1, 0.4};
  base.kind = MotionKind::acceleration;
  base.history = SineCycles{100, 1, 0};
  model.held_blocks = {base};
  add_sides(0, model);
  model.stages = {stage_of(generalized_alpha_integrator(0.8), 1e-4, 200)};
  return model;
}

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Largest difference of the velocities of any row's centroids, in any of its blocks, from those of the columns; of the
// columns' largest.
inline double difference_from_columns(Simulation& simulation, int steps) {
  double difference = 0, largest = 0;
  for (int i = 0; i < steps; ++i) {
    run(simulation, 1);
    const State& whole = simulation.state();
    const State& column = simulation.free_field_columns()->state();
    for (int block = 0; block < rows * columns; ++block) {
      const Vec2 expected = column.velocity[at(block / columns)].head<2>();
      difference = std::max(difference, (whole.velocity[at(block)].head<2>() - expected).norm());
      largest = std::max(largest, expected.norm());
    }
  }
  return difference / largest;
}

}  // namespace dda::free_field
