// Blocks that are moved far in static stages that pace themselves push others before them.
#include <gtest/gtest.h>

#include <random>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

using Random = std::mt19937;

double between(double least, double most, Random& random) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

TEST(PushedBlocks, GoAsFarAsTheyArePushed) {
  Random random(71);
  for (int i = 0; i < 8; ++i) {
    const double way = between(0.05, 0.6, random);
    const double width = between(0.5, 1.5, random);
    Model model;
    model.materials = {{"rock", 2600, 2e10, 0.2, PlaneState::stress}};
    model.joints = {{.name = "rough", .law = InterfaceLaw::classical, .friction_angle = between(0, 0.5, random)}};
    model.blocks = {rectangle("floor", 0, -1, 6, 1), rectangle("stone", 0.8, 0, width, 1),
                    rectangle("pusher", 0.3, 0.01, 0.5, 0.98)};
    model.held_blocks.resize(2);
    model.held_blocks[0].block = 0;
    model.held_blocks[1].block = 2;
    model.held_blocks[1].amplitude = {way / 0.5, 0};
    model.held_blocks[1].kind = MotionKind::velocity;
    model.held_blocks[1].history = Constant{};
    model.gravity = {0, -9.81};
    Stage stage;
    stage.integrator = static_integrator();
    stage.duration = 0.5;
    stage.equilibrium = 1e-9;
    model.stages = {stage};
    Simulation simulation = simulation_of(model);
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << i << ": " << simulation.message();
    EXPECT_NEAR(simulation.state().displacement[2](0), way, 1e-12);
    EXPECT_NEAR(simulation.state().displacement[1](0), way, 1e-4) << i;  // m, what springs and the block give way
    EXPECT_NEAR(simulation.state().displacement[1](1), 0, 1e-4) << i;
    EXPECT_LT(simulation.deepest_penetration().share, 1e-3) << i;
  }
}

}  // namespace
}  // namespace dda
