// What pulls and pushes blocks in static stages that pace themselves: they go as far as they are pushed, and the work
// on what slides is that of a slow change.
#include <gtest/gtest.h>

#include <cmath>
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

// A stone under its weight on a floor with friction, at rest, and a stage of a second in which something changes.
struct Dragged {
  Model model;
  double friction = 0;  // N, the most
  double spring = 0;    // N/m

  explicit Dragged(Random& random) {
    const double width = between(1, 4, random), height = between(0.5, 1, random), angle = between(0.2, 0.7, random);
    model.materials = {{"rock", 2600, 1e12, 0, PlaneState::strain}};  // what it strains by is little beside its way
    model.joints = {{.name = "rough", .law = InterfaceLaw::projected, .friction_angle = angle}};
    model.blocks = {rectangle("floor", -2, -1, 10, 1), rectangle("stone", 0, 0, width, height)};
    model.held_blocks.emplace_back().block = 0;
    model.gravity = {0, -10};
    friction = 2600 * 10 * width * height * std::tan(angle);
    spring = friction / between(1e-4, 1e-3, random);
    PointSupport& support = model.supports.emplace_back();
    support.block = 1;
    support.point = {width, 0.05};
    support.holds_y = false;
    support.stiffness = spring;
    Stage stage;
    stage.integrator = static_integrator();
    stage.equilibrium = 1e-9;
    model.stages = {stage, stage};
    model.stages[1].duration = 1;
  }

  // Takes both stages; what the second did: W, Wj and Wk, J.
  [[nodiscard]] Vec3 works() const {
    Simulation simulation = simulation_of(model);
    while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const EnergyLedger& before = simulation.results().energy[0];
    const EnergyLedger& after = simulation.results().energy[1];
    return {after.external_work - before.external_work, after.friction - before.friction,
            after.damping + after.numerical - before.damping - before.numerical};
  }
};

// One of 32 parts of the way: in each something slides or yields at one load, and rock lags behind a little.
constexpr double share = 0.03;

const TimeFunction ramp = PiecewiseLinear{{0, 1}, {0, 1}};

// The loads of its end, from its first step on, took W = 1,229 J for 220, or -624 J when it was booked by their mean.
TEST(PushedBlocks, WorkOfAPulledSpringIsThatOfASlowPull) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    Dragged scene(random);
    const double way = between(1.5, 8, random) * scene.friction / scene.spring;
    scene.model.supports[0].amplitude = {way, 0};
    scene.model.supports[0].history = ramp;
    const double slid = way - scene.friction / scene.spring;
    const Vec3 works = scene.works();
    const double expected = scene.friction * (scene.friction / (2 * scene.spring) + slid);
    EXPECT_NEAR(works(0), expected, share * expected) << i;
    EXPECT_NEAR(works(1), scene.friction * slid, share * expected) << i;
    EXPECT_NEAR(works(2), 0, share * expected) << i;
  }
}

TEST(PushedBlocks, WorkOfAForceThatGrowsIsThatOfASlowPush) {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    Dragged scene(random);
    const double force = between(1.5, 4, random) * scene.friction;
    PointLoad& load = scene.model.point_loads.emplace_back();
    load.block = 1;
    load.point = {0, 0.05};
    load.force = {force, 0};
    load.history = ramp;
    load.stages.first = 1;
    const double slid = (force - scene.friction) / scene.spring;
    const Vec3 works = scene.works();
    const double expected = (scene.friction + scene.spring * slid / 2) * slid;
    EXPECT_NEAR(works(0), expected, share * expected) << i;
    EXPECT_NEAR(works(1), scene.friction * slid, share * expected) << i;
    EXPECT_NEAR(works(2), 0, share * expected) << i;
  }
}

}  // namespace
}  // namespace dda
