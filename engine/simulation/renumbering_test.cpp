// The numbers that a scene happens to give its blocks are no part of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/stability_limit.h"

namespace dda {
namespace {

// Bonded squares of two rocks, shaken at a point.
Model mixed_mesh(Random& random) {
  Model model;
  model.materials = {{"hard", 2600, 2e10, 0.2, PlaneState::stress},
                     {"soft", 2600, 2e10 / between(1.2, 4, random), 0.2, PlaneState::stress}};
  model.joints = {bond(InterfaceLaw::consistent)};
  const int columns = std::uniform_int_distribution<int>(3, 6)(random);
  const int rows = std::uniform_int_distribution<int>(1, 3)(random);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      model.blocks.push_back(rectangle("", column, row, 1, 1));
      model.blocks.back().material = std::bernoulli_distribution(0.5)(random) ? 1 : 0;
    }
  const int block = std::uniform_int_distribution<int>(0, rows * columns - 1)(random);
  const Vec2 middle(block % columns + 0.5, block / columns + 0.5);
  model.point_loads.push_back({block, middle, {1e6, 3e5}, SineCycles{600, 3, 0}});
  return model;
}

// Block i becomes number place[i].
Model renumbered(const Model& model, const std::vector<int>& place) {
  Model other = model;
  for (std::size_t i = 0; i < place.size(); ++i) other.blocks[static_cast<std::size_t>(place[i])] = model.blocks[i];
  for (PointLoad& load : other.point_loads) load.block = place[static_cast<std::size_t>(load.block)];
  return other;
}

std::vector<Vec6> displacements(const Model& model) {
  Simulation simulation = simulation_of(model);
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.state().displacement;
}

void expect_same(Model model, const Stage& stage, Random& random) {
  model.stages = {stage};
  std::vector<int> place(model.blocks.size());
  std::iota(place.begin(), place.end(), 0);
  std::ranges::shuffle(place, random);
  const std::vector<Vec6> one = displacements(model);
  const std::vector<Vec6> other = displacements(renumbered(model, place));
  double largest = 0;
  for (const Vec6& each : one) largest = std::max(largest, each.norm());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_LT((one[i] - other[static_cast<std::size_t>(place[i])]).norm(), 1e-9 * largest)  // sums in another order
        << stage.integrator.name << " " << stage.dt;
}

TEST(Renumbering, ChangesNothingInAMeshOfTwoRocks) {
  Random random(58);
  for (int i = 0; i < 40; ++i) {
    Model model = mixed_mesh(random);
    Stage stage = stage_of(central_difference_integrator(), 1e-9, 1);
    stage.correct_block_dispersion = stage.correct_time_dispersion = true;
    model.stages = {stage};
    finish_model(model);
    const double limit = stability_limit(model, 0);
    stage.dt = between(0.3, 0.95, random) * limit;
    stage.duration = 60 * stage.dt;
    expect_same(model, stage, random);
    stage.integrator = i % 2 ? trapezoidal_integrator() : hht_integrator(0.1);
    stage.dt = between(0.3, 3, random) * limit;
    stage.duration = 60 * stage.dt;
    expect_same(model, stage, random);
  }
}

}  // namespace
}  // namespace dda
