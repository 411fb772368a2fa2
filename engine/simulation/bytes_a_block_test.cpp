// How many bytes a block a bonded scene takes when it takes most, its model and set-up included. Four kilobytes are
// what a grid may take (ADR 83); rectangles with round-off in their heights have more kinds of elements.
#include <gtest/gtest.h>

#include <utility>

#include "engine/core/allocation_counter.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr int side = 70;

Model grid_of_squares() {
  Model model;
  model.materials = {rock()};
  model.joints = {bond(InterfaceLaw::consistent)};
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      model.blocks.emplace_back().shape.outer = box_ring(column, row, column + 1, row + 1);
  return model;
}

// The first row of blocks is pushed, from zero on: a sudden load would have accelerations solved for at the start.
double most_bytes_a_block(Model (*make)(), const Integrator& integrator) {
  const long before = bytes_in_use();
  forget_most_bytes_in_use();
  Model model = make();
  const auto blocks = static_cast<double>(model.blocks.size());
  for (int block = 0; block < side; ++block)
    model.point_loads.push_back({block, Vec2(block + 0.5, 0), Vec2(0, 1e5), SineCycles{100}});
  model.stages = {stage_of(integrator, 1e-5, 3)};
  model.stages[0].solver = SolverRequest::pcg;
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 3);
  return static_cast<double>(most_bytes_in_use() - before) / blocks;
}

TEST(BytesABlock, OfSquaresInExplicitSteps) {
  EXPECT_LT(most_bytes_a_block(&grid_of_squares, central_difference_integrator()), 3500);
}

TEST(BytesABlock, OfSquaresInImplicitSteps) {
  EXPECT_LT(most_bytes_a_block(&grid_of_squares, generalized_alpha_integrator(0.85)), 4000);
}

// Heights are 0.7 m.
TEST(BytesABlock, OfRectanglesInImplicitSteps) {
  const auto make = [] { return grid_of(side, bond(InterfaceLaw::consistent)); };
  EXPECT_LT(most_bytes_a_block(make, generalized_alpha_integrator(0.85)), 4500);
}

}  // namespace
}  // namespace dda
