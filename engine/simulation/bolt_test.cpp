// Rock bolts between blocks, against what can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double stiffness = 2e7;   // N/m
constexpr double pretension = 3e4;  // N
constexpr double yield_force = 8e4;

Bolt bolt_between(const Vec2& from, const Vec2& to) {
  Bolt bolt;
  bolt.name = "bolt";
  bolt.direction = (to - from).normalized();
  bolt.links = {{0, 1, from, to, stiffness, 0}};
  bolt.pretension = pretension;
  bolt.yield_force = yield_force;
  return bolt;
}

// Two held blocks 2 m apart, the right one moved along x by `history` times 1 m.
Model two_held_blocks(const TimeFunction& history, Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("left", 0, 0, 1, 1), rectangle("right", 3, 0, 1, 1)};
  model.held_blocks = {HeldBlock{}, HeldBlock{}};
  model.held_blocks[1].block = 1;
  model.held_blocks[1].amplitude = {1, 0};
  model.held_blocks[1].history = history;
  model.bolts = {bolt_between({0.5, 0.5}, {3.5, 0.5})};
  model.stages = {stage_of(thesis_integrator(), 1e-3, 60, kinematics)};
  return model;
}

double axial_force(const Simulation& simulation) { return simulation.bolts().state(0, 0).force(0); }

// Held from both sides its force is a function of the history alone; each reading is exact but for round-off of
// stiffness times positions of 1 m.
constexpr double force_round_off = 1e-15 * stiffness;

// Out to 5 mm, back to -4 mm, out to 6 mm: elastic, yields (plastic 2.5 mm), unloads, goes slack, takes up where it
// left off, yields again.
TEST(BoltForce, FollowsElongationYieldsAndGoesSlack) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    const PiecewiseLinear history{{0, 0.020, 0.040, 0.060}, {0, 5e-3, -4e-3, 6e-3}};
    Simulation simulation = simulation_of(two_held_blocks(history, kinematics));
    double plastic = 0;  // m
    bool went_slack = false;
    while (!simulation.finished()) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      const double elongation = evaluate(history, simulation.state().time);
      plastic = std::max(plastic, elongation - (yield_force - pretension) / stiffness);
      const double elastic = pretension + stiffness * (elongation - plastic);
      EXPECT_NEAR(axial_force(simulation), std::max(0.0, elastic), force_round_off);
      EXPECT_NEAR(simulation.bolts().elongation(0, 0), elongation, 1e-15);
      went_slack = went_slack || elastic < 0;
    }
    EXPECT_TRUE(went_slack);
    EXPECT_NEAR(plastic, 3.5e-3, 1e-15);
    EXPECT_NEAR(simulation.energy().plastic, yield_force * plastic, 1e-12 * yield_force * plastic);
    EXPECT_NEAR(simulation.energy().bolts, yield_force * yield_force / (2 * stiffness), 1e-9);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
  }
}

TEST(BoltForce, YieldsInCompressionWhereItCanPush) {
  const PiecewiseLinear history{{0, 0.020, 0.060}, {0, -8e-3, 8e-3}};
  Model model = two_held_blocks(history, Kinematics::small);
  model.bolts[0].tension_only = false;
  Simulation simulation = simulation_of(std::move(model));
  double plastic = 0;
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double elongation = evaluate(history, simulation.state().time);
    const double free = pretension + stiffness * (elongation - plastic);
    plastic += (std::max(free - yield_force, 0.0) + std::min(free + yield_force, 0.0)) / stiffness;
    EXPECT_NEAR(axial_force(simulation), pretension + stiffness * (elongation - plastic), force_round_off);
  }
  EXPECT_GT(plastic, 0);
}

// Breaks at 4 mm, 0.4 mm a step: gone from the step on that passes it, and for good. What it had stored is dissipated.
TEST(BoltForce, BreaksAtItsElongation) {
  const PiecewiseLinear history{{0, 0.020, 0.040}, {0, 8e-3, 0}};
  Model model = two_held_blocks(history, Kinematics::finite);
  model.bolts[0].rupture_elongation = 4.1e-3;
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 10);
  EXPECT_EQ(axial_force(simulation), yield_force);
  run(simulation, 1);
  EXPECT_EQ(axial_force(simulation), 0);
  EXPECT_TRUE(simulation.bolts().state(0, 0).ruptured);
  run(simulation, 49);
  EXPECT_EQ(axial_force(simulation), 0);
  EXPECT_EQ(simulation.energy().bolts, 0);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
  // Initial store and the work of pulling; the last of the eleven steps ends without force.
  const double stored = pretension * pretension / (2 * stiffness);
  EXPECT_NEAR(simulation.energy().plastic + simulation.energy().numerical, stored + simulation.energy().external_work,
              1e-9);
}

// The line of action follows the anchors: the right block goes round the left one's anchor by 70 degrees and away.
TEST(BoltForce, FollowsItsAnchorsThroughLargeTurns) {
  Model model = two_held_blocks(Constant{}, Kinematics::finite);
  model.bolts[0].yield_force = 1e30;
  HeldBlock& swung = model.held_blocks[1];
  swung.about = {0.5, 0.5};
  swung.turn = 70 * std::numbers::pi / 180;
  swung.amplitude = {0.4, 0.3};
  swung.history = PiecewiseLinear{{0, 0.060}, {0, 1}};
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double share = evaluate(swung.history, simulation.state().time);
    const double turned = share * swung.turn;
    const Vec2 span = 3 * Vec2(std::cos(turned), std::sin(turned)) + share * Vec2(0.4, 0.3);
    // Within a step the line of action is that of its start: the force is then off by k |span|/2 times the square of
    // the turn of a step, 0.02; it is measured anew at the start of the next.
    EXPECT_NEAR(axial_force(simulation), pretension + stiffness * (span.norm() - 3), stiffness * 3 * 0.021 * 0.021 / 2);
  }
  // The next step starts from what is measured.
  Simulation again = simulation_of([&] {
    Model longer = two_held_blocks(Constant{}, Kinematics::finite);
    longer.bolts[0].yield_force = 1e30;
    longer.held_blocks[1] = swung;
    longer.stages[0].duration = 0.061;
    return longer;
  }());
  run(again, 61);
  const double end = (3 * Vec2(std::cos(swung.turn), std::sin(swung.turn)) + Vec2(0.4, 0.3)).norm();
  EXPECT_NEAR(axial_force(again), pretension + stiffness * (end - 3), 10 * force_round_off);
}

// A block hangs on a bolt below a held roof: its weight, and weight/k of elongation beyond the pretension's.
TEST(Bolts, HoldAHangingBlock) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model;
    model.materials = {rock()};
    model.blocks = {rectangle("roof", 0, 4, 3, 1), rectangle("block", 1, 0, 1, 2)};
    model.held_blocks = {HeldBlock{}};
    model.gravity = {0, -10};
    model.bolts = {bolt_between({1.5, 4.5}, {1.5, 1})};
    model.stages = {stage_of(static_integrator(), 0.05, 100, kinematics)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 100);
    constexpr double weight = 2600 * 2 * 10;
    EXPECT_NEAR(axial_force(simulation), weight, 1e-9 * weight);
    EXPECT_NEAR(simulation.state().displacement[1](1), -(weight - pretension) / stiffness, 1e-12);
    EXPECT_LT(simulation.out_of_balance(), 1e-9);
  }
}

// Beyond its yield force it lets the block fall; the bolt at its capacity takes g down to g - N/m.
TEST(Bolts, YieldUnderTooMuchWeight) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("roof", 0, 8, 3, 1), rectangle("block", 0.5, 0, 2, 4)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -10};
  model.bolts = {bolt_between({1.5, 8.5}, {1.5, 2})};
  model.bolts[0].pretension = yield_force;
  model.stages = {stage_of(trapezoidal_integrator(), 1e-3, 100, Kinematics::small)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 100);
  const double mass = 2600 * 8;
  const double acceleration = 10 - yield_force / mass;
  EXPECT_NEAR(simulation.state().displacement[1](1), -acceleration * 0.1 * 0.1 / 2, 1e-12);
  EXPECT_NEAR(simulation.energy().plastic, yield_force * acceleration * 0.1 * 0.1 / 2, 1e-7);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
}

// A block thrown away from the bolt that holds it: all its energy goes into the bolt, what is beyond the elastic limit
// into yielding; then it swings about the new length.
TEST(Bolts, ElasticPlasticOscillator) {
  constexpr double speed = 0.5;
  constexpr double mass = 2600;
  std::vector<double> errors;
  for (const double dt : {4e-4, 2e-4}) {
    Model model;
    model.materials = {rock()};
    model.blocks = {rectangle("base", 0, 0, 1, 1), rectangle("block", 3, 0, 1, 1)};
    model.blocks[1].initial_velocity = {speed, 0};
    model.held_blocks = {HeldBlock{}};
    model.bolts = {bolt_between({0.5, 0.5}, {3.5, 0.5})};
    model.bolts[0].pretension = 0;
    model.stages = {stage_of(trapezoidal_integrator(), dt, static_cast<int>(std::lround(0.06 / dt)))};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, static_cast<int>(std::lround(0.06 / dt)));
    const double plastic = (mass * speed * speed - yield_force * yield_force / stiffness) / (2 * yield_force);
    ASSERT_GT(plastic, 1e-4);
    errors.push_back(simulation.bolts().state(0, 0).plastic(0) / plastic - 1);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
  // Second order, but where yielding begins within a step: measured 1.5e-4 and less.
  EXPECT_LT(std::abs(errors[0]), 1e-3);
  EXPECT_LT(std::abs(errors[1]), 3e-4);
}

// A grouted bolt through two joints of a row of three held blocks, turned by 90 degrees all together while the second
// opens and shears against the first, and the third against the second beyond the dowel's strength.
TEST(GroutedBolt, AnswersAtEveryJointAndTurnsWithTheBlocks) {
  Model model;
  model.materials = {rock()};
  model.joints = {bond(InterfaceLaw::classical)};
  model.blocks = {rectangle("a", 0, 0, 1, 1), rectangle("b", 1, 0, 1, 1), rectangle("c", 2, 0, 1, 1)};
  Bolt bolt;
  bolt.name = "bolt";
  bolt.grouted = true;
  bolt.links = {{0, 1, {1, 0.5}, {1, 0.5}, stiffness, 5e6}, {1, 2, {2, 0.5}, {2, 0.5}, stiffness, 5e6}};
  bolt.shear_yield_force = 5e3;
  model.bolts = {bolt};
  for (int block = 0; block < 3; ++block) {
    HeldBlock held;
    held.block = block;
    held.turn = std::numbers::pi / 2;
    held.about = {0, 0};
    // In the turned row: along is +y, across is -x.
    if (block == 1) held.amplitude = {-5e-4, 1e-3};
    if (block == 2) held.amplitude = {-35e-4, 1.5e-3};
    held.history = PiecewiseLinear{{0, 0.080}, {0, 1}};
    model.held_blocks.push_back(held);
  }
  // Turns of 2e-3 a step: within it motions are linear, and gaps are off by half its square.
  model.stages = {stage_of(thesis_integrator(), 1e-4, 802, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 802);
  const Vec2 first = simulation.bolts().state(0, 0).force;
  const Vec2 second = simulation.bolts().state(0, 1).force;
  constexpr double round_off = 802 * 1e-16 * stiffness;  // a product of rotations each step
  EXPECT_NEAR(first(0), stiffness * 1e-3, round_off);
  EXPECT_NEAR(first(1), 5e6 * 5e-4, round_off);
  EXPECT_NEAR(second(0), stiffness * 0.5e-3, round_off);
  EXPECT_NEAR(second(1), 5e3, 5e6 * 2e-6);
  EXPECT_GT(simulation.bolts().state(0, 1).plastic(1), 1.9e-3);
}

// Many bolts that yield, go slack and break while blocks slide and rock: every step settles, and what it settles on is
// in balance.
TEST(Bolts, SettleTogetherWithContacts) {
  Model model;
  model.materials = {rock()};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -2, -1, 12, 1)};
  for (int i = 0; i < 6; ++i) model.blocks.push_back(rectangle("", 1.2 * i, 0, 1, 1.5));
  for (std::size_t i = 1; i < model.blocks.size(); ++i)
    model.blocks[i].initial_velocity = {(i % 2 == 0 ? 0.8 : -0.8), 0};
  model.held_blocks = {HeldBlock{}};
  model.held_blocks[0].amplitude = {3, 0};
  model.held_blocks[0].kind = MotionKind::acceleration;
  model.held_blocks[0].history = SineCycles{8, 100, 0};
  model.gravity = {0, -10};
  for (int i = 1; i < 6; ++i) {
    Bolt bolt = bolt_between({1.2 * i - 0.7, 1.2}, {1.2 * i + 0.5, 0.3});
    bolt.name += std::to_string(i);
    bolt.links[0].block_a = i;
    bolt.links[0].block_b = i + 1;
    bolt.pretension = 5e3;
    bolt.yield_force = 2e4;
    if (i == 3) bolt.rupture_elongation = 0.02;
    model.bolts.push_back(bolt);
  }
  model.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 600, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 600);
  EXPECT_GT(simulation.energy().plastic, 100);
  EXPECT_TRUE(simulation.bolts().state(2, 0).ruptured);
  EXPECT_LT(simulation.counters().open_close_iterations, 600 * 8);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-4);
}

}  // namespace
}  // namespace dda
