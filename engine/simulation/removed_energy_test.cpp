// What blocks that are taken out had stored, under a stress that is the same in all directions: that of their strains,
// and where springs close their joints that of the springs.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double pressure = 5e6, young = 20e9, poisson = 0.2;

Stage settled(const char* name) {
  Stage stage;
  stage.name = name;
  stage.integrator = static_integrator();
  stage.kinematics = Kinematics::finite;
  stage.equilibrium = 1e-9;
  return stage;
}

// `taken`, which squares of 1 m surround to the edge of (0, 0) to (5, 5) m, with the outermost held.
double removed_of(Block taken, const JointMaterial& joint) {
  Model model;
  model.materials = {{"rock", 2600, young, poisson, PlaneState::strain}};
  model.joints = {joint};
  model.blocks = {std::move(taken)};
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) {
      if (locate(model.blocks[0].shape, {x + 0.5, y + 0.5}, 0) != Location::outside) continue;
      const bool is_outermost = x == 0 || x == 4 || y == 0 || y == 4;
      if (is_outermost) model.held_blocks.emplace_back().block = static_cast<int>(model.blocks.size());
      model.blocks.emplace_back().shape.outer = box_ring(x, y, x + 1, y + 1);
    }
  for (Block& block : model.blocks) block.initial_stress = {-pressure, -pressure, 0};
  model.stages = {settled("in situ"), settled("taken out")};
  model.stages[1].removal.blocks = {0};
  Simulation simulation = simulation_of(std::move(model));
  Status status = Status::ok;
  while (status == Status::ok && !simulation.finished()) status = simulation.step();
  EXPECT_EQ(status, Status::ok) << simulation.message();
  return simulation.energy().removed;
}

double strain_energy_of(double area) { return pressure * pressure * (1 + poisson) * (1 - 2 * poisson) / young * area; }

Block corner_block() {
  Block block;
  block.shape.outer = {{1, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}};
  return block;
}

TEST(RemovedEnergy, OfProjectedJointsIsThatOfTheStrains) {
  const double removed = removed_of(rectangle("taken", 2, 2, 1, 1), dry_projected(1));
  EXPECT_NEAR(removed / strain_energy_of(1), 1, 1e-12);  // round-off
}

// Whether the blocks could touch elsewhere as well or not: here the corner and the square in its notch. They had
// springs there, which stored 0.33 % of that.
TEST(RemovedEnergy, OfBlocksWithInwardCornersIsThatOfTheStrains) {
  const double removed = removed_of(corner_block(), dry_projected(1));
  EXPECT_NEAR(removed / strain_energy_of(3), 1, 1e-12);
}

// All around a block springs as stiff as is chosen for them, k = 100 E/t a metre with t the area over the diameter,
// store p^2 t/(200 E) times the outline: of a square 1.96 %, and of no convex block more than the 2.2 % of a circle.
TEST(RemovedEnergy, OfSpringsAllAroundIsTwoPercentMore) {
  JointMaterial springs = dry_projected(1);
  springs.law = InterfaceLaw::classical;
  springs.automatic_stiffness = true;
  const double removed = removed_of(rectangle("taken", 2, 2, 1, 1), springs);
  EXPECT_NEAR(removed / strain_energy_of(1), 1 + 4 / (200 * std::sqrt(2.0) * (1 + poisson) * (1 - 2 * poisson)), 1e-9);
}

}  // namespace
}  // namespace dda
