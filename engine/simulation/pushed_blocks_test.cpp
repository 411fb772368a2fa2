// What pulls and pushes blocks in static stages that pace themselves: they go as far as they are pushed, and the work
// on what slides is that of a slow change.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/simulation/measured_models.h"
#include "engine/simulation/random_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

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

// A stage of rest and one in which a held block moves in a straight line, however far.
void rest_and_move(Model& model) {
  model.held_blocks[0].history = ramp;
  model.gravity = {0, -9.81};
  Stage stage;
  stage.integrator = static_integrator();
  stage.equilibrium = 1e-9;
  model.stages = {stage, stage};
  model.stages[1].duration = 1;
}

// Stone is so stiff that the turn of one part takes joints off by far more than the weight compresses; before, floors
// slid away under blocks in the first short step, and blocks fell freely in long ones.
TEST(PushedBlocks, RideAlongOnAFloorThatTurns) {
  Random random(17);
  for (int i = 0; i < 20; ++i) {
    const double width = between(0.3, 3, random), turn = between(-0.35, 0.35, random);
    Model model;
    model.materials = {{"stone", 2400, std::pow(10, between(9, 11.3, random)), 0.2, PlaneState::stress}};
    model.joints = {{.name = "dry", .law = InterfaceLaw::projected, .friction_angle = 0.8}};
    model.blocks = {rectangle("floor", -4, -1, 8, 1), rectangle("stone", between(-2, 0, random), 0, width, width),
                    rectangle("other", 3, 0, 0.5, 0.5)};
    HeldBlock& floor = model.held_blocks.emplace_back();
    floor.block = 0;
    floor.turn = turn;
    floor.about = {between(-2, 2, random), 0};
    rest_and_move(model);
    Simulation simulation = simulation_of(model);
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << i << ": " << simulation.message();
    for (const std::size_t block : {1U, 2U}) {
      const Vec2 arm = simulation.model().blocks[block].moments.centroid - floor.about;
      const Vec2 ridden = Eigen::Rotation2Dd(turn) * arm - arm;
      const Vec2 moved = simulation.state().displacement[block].head<2>();
      // Measured: 3e-5 and, of the small one that is carried by up to twice its size, 1.2e-3.
      EXPECT_LT((moved - ridden).norm(), block == 1 ? 1e-4 * width : 2e-3 * 0.5) << i;
      EXPECT_NEAR(simulation.state().displacement[block](2), turn, 1e-4) << i;
    }
  }
}

// A round arch of voussoirs on two springers, of which the right one goes out. Halves still touch at the crown outside
// and at the haunches inside, and turn about these as a whole: the thrust is the weight between two such hinges times
// its arm, over their rise, and the haunches are where that is most.
struct SpreadArch {
  double radius, depth, spread;  // m, of the middle line; of the ring; how far the springer goes
  int voussoirs;                 // even: with a joint in the crown
  std::vector<Ring> rings;

  SpreadArch(double scale, Random& random)
      : radius(scale * std::pow(10, between(-0.6, 0.7, random))),
        depth(radius * between(0.14, 0.25, random)),
        spread(radius * between(0.002, 0.06, random)),
        voussoirs(2 * std::uniform_int_distribution(4, 10)(random)) {
    for (int i = 0; i < voussoirs; ++i) rings.push_back({inside(i), outside(i), outside(i + 1), inside(i + 1)});
  }

  [[nodiscard]] Vec2 at(double from_middle, int joint) const {
    const double angle = std::numbers::pi * joint / voussoirs;
    return (radius + from_middle) * Vec2(std::cos(angle), std::sin(angle));
  }
  [[nodiscard]] Vec2 inside(int joint) const { return at(-depth / 2, joint); }
  [[nodiscard]] Vec2 outside(int joint) const { return at(depth / 2, joint); }

  [[nodiscard]] Model model(double young) const {
    Model model;
    model.materials = {{"stone", density, young, 0.2, PlaneState::stress}};
    model.joints = {{.name = "dry", .law = InterfaceLaw::projected, .friction_angle = 0.8}};
    model.blocks = {rectangle("right", radius - depth, -depth, 2 * depth, depth),
                    rectangle("left", -radius - depth, -depth, 2 * depth, depth)};
    for (const Ring& ring : rings) model.blocks.emplace_back().shape.outer = ring;
    for (std::size_t i = 2; i < model.blocks.size(); ++i) model.blocks[i].name = fmt::format("voussoir {}", i);
    model.held_blocks.resize(2);
    model.held_blocks[0].amplitude = {spread, 0};
    model.held_blocks[1].block = 1;
    rest_and_move(model);
    Measurement& thrust = model.measurements.emplace_back();
    thrust.name = "thrust";
    thrust.quantity = Quantity::reaction;
    thrust.blocks = {0};
    return model;
  }

  // The half on the right has turned about its haunch so far that the crown is in the middle again.
  [[nodiscard]] double thrust() const {
    double most = 0;
    for (int haunch = 0; haunch < voussoirs / 2 - 1; ++haunch) most = std::max(most, thrust_about(haunch));
    return most;
  }

  [[nodiscard]] double thrust_about(int haunch) const {
    const Vec2 foot = inside(haunch), arm = outside(voussoirs / 2) - foot;
    const double span = -arm.x() + spread / 2, length = arm.norm();
    const double rise = std::sqrt(length * length - span * span);
    const double turn = std::atan2(rise, -span) - std::atan2(arm.y(), arm.x());
    double moment = 0;
    for (int i = haunch; i < voussoirs / 2; ++i) {
      const AreaMoments piece = area_moments(Polygon{rings[static_cast<std::size_t>(i)], {}});
      moment += density * 9.81 * piece.area * -(Eigen::Rotation2Dd(turn) * (piece.centroid - foot)).x();
    }
    return moment / rise;
  }

  static constexpr double density = 2400;  // kg/m3
};

double thrust_of_run(const SpreadArch& arch, double young) {
  Simulation simulation = simulation_of(arch.model(young));
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return -sampled(simulation).at(0);
}

// The joint in which a haunch opens may be the neighbour of the one that the closed form has: of 160 arches 147 were
// within 1 %, 12 within 2.5 %, and one was 6 % off. (With parts of a hundredth of a voussoir half were further off.)
TEST(PushedBlocks, ArchOnASpringerThatGoesOutHasTheLeastThrust) {
  Random random(19);
  int next_joint = 0;
  for (int i = 0; i < 40; ++i) {
    const SpreadArch arch(1, random);
    const double young = std::pow(10, between(9.3, 11.3, random));
    const double share = thrust_of_run(arch, young) / arch.thrust();
    EXPECT_NEAR(share, 1, 0.025) << i << ": " << arch.voussoirs << " voussoirs, " << young << " Pa";
    if (std::abs(share - 1) > 0.01) ++next_joint;
  }
  EXPECT_LE(next_joint, 1);
}

// Models of arches are millimetres to centimetres large. The smaller and stiffer they are, the shorter is the transit
// of a wave beside the time in which voussoirs fall: steps of a hundred of them left these hanging as the springer
// went. (Of 49 others 11 stopped or were more than 2.5 % off, now none; of 11 that go out by 6 % four are still.)
TEST(PushedBlocks, SmallArchesHaveTheLeastThrustToo) {
  Random random(23);
  for (int i = 0; i < 20; ++i) {
    SpreadArch arch(0.01, random);
    arch.spread /= 2;  // 3 % of the radius at most
    const double young = std::pow(10, between(10, 11.3, random));
    EXPECT_NEAR(thrust_of_run(arch, young) / arch.thrust(), 1, 0.025) << i << ": " << arch.radius << " m, " << young;
  }
}

}  // namespace
}  // namespace dda
