// Stages of small kinematics before finite ones.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// Smooth squares that touch, two of them dragged by some metres, far beyond where contacts are looked for.
Model dragged_squares(Random& random) {
  Model model;
  model.materials = {{"rock", 2600, 2e10, 0.2, PlaneState::stress}};
  model.joints = {{.name = "smooth", .law = InterfaceLaw::classical}};
  const int columns = std::uniform_int_distribution<int>(2, 4)(random);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < columns; ++column) model.blocks.push_back(rectangle("", column, row, 1, 1));
  const auto pull = [&](int block, double sign) {
    const Vec2 middle(block % columns + 0.5, block / columns + 0.5);
    model.point_loads.push_back({block, middle, sign * Vec2(between(1e6, 3e6, random), between(-1e6, 0, random)), {}});
    model.point_loads.back().history = Constant{};
  };
  pull(columns, -1);
  pull(columns - 1, 1);
  return model;
}

State after_small_stage(Model model, const std::vector<Stage>& stages) {
  model.stages = stages;
  Simulation simulation = simulation_of(model);
  for (std::int64_t i = 0; i < simulation.model().stages[0].steps(); ++i)
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.state();
}

TEST(KinematicsOfStages, ASmallStageIsTheSameWhateverComesAfterIt) {
  Random random(74);
  for (int i = 0; i < 12; ++i) {
    const Model model = dragged_squares(random);
    const Integrator integrator = i % 2 ? trapezoidal_integrator() : thesis_integrator();
    const Stage small = stage_of(integrator, 2e-3, 50, Kinematics::small);
    const State alone = after_small_stage(model, {small});
    const State before = after_small_stage(model, {small, stage_of(integrator, 1e-4, 1, Kinematics::finite)});
    double farthest = 0;
    for (std::size_t block = 0; block < model.blocks.size(); ++block) {
      farthest = std::max(farthest, alone.displacement[block].head<2>().norm());
      EXPECT_LT((alone.displacement[block] - before.displacement[block]).norm(), 1e-9) << i;  // m, of metres
    }
    EXPECT_GT(farthest, 0.5);
  }
}

}  // namespace
}  // namespace dda
