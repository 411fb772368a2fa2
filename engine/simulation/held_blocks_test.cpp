// Blocks whose motion is prescribed, and what they do to others.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "engine/simulation/block_system.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

TimeFunction ground_motion() {
  return Recorded{std::make_shared<const Recording>("", std::vector{0.0, 0.013, 0.021, 0.04, 0.06},
                                                    std::vector{0.0, 3.0, -5.0, 2.0, 0.0}),
                  0.002};
}

HeldBlock shaken(int block, MotionKind kind = MotionKind::acceleration) {
  HeldBlock held;
  held.block = block;
  held.amplitude = {1, -0.5};
  held.history = ground_motion();
  held.kind = kind;
  return held;
}

// Three blocks in a row, the first of which is shaken.
Model shaken_bar(const JointMaterial& joint, const Stage& stage) {
  Model model = bar_of(3, joint);
  model.held_blocks = {shaken(0)};
  model.stages = {stage};
  return model;
}

struct Way {
  JointMaterial joint;
  Kinematics kinematics;
};

// The linear step, the general one, and the general one with geometry that follows.
std::vector<Way> ways() {
  return {{bond(InterfaceLaw::consistent), Kinematics::small},
          {strong(InterfaceLaw::classical), Kinematics::small},
          {strong(InterfaceLaw::consistent), Kinematics::finite},
          {bond(InterfaceLaw::classical), Kinematics::finite}};
}

// The round-off of sums of increments below 1e-2 m.
constexpr double round_off = 1e-16;

TEST(HeldBlocks, FollowTheRecordExactly) {
  for (const Integrator& integrator : dynamic_integrators())
    for (const Way& way : ways()) {
      Simulation simulation = simulation_of(shaken_bar(way.joint, stage_of(integrator, 1e-3, 70, way.kinematics)));
      while (!simulation.finished()) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        const MotionFactors motion = motion_at(MotionKind::acceleration, ground_motion(), simulation.state().time);
        const State& state = simulation.state();
        EXPECT_NEAR(state.displacement[0](0), motion.displacement, round_off) << integrator.name;
        EXPECT_NEAR(state.displacement[0](1), -motion.displacement / 2, round_off);
        EXPECT_EQ(state.displacement[0].tail<4>(), Eigen::Vector4d::Zero());
        // The moment differs from the state's by round-off, and slopes are up to 1e3.
        EXPECT_NEAR(state.velocity[0](0), motion.velocity, 1e-15);
        EXPECT_NEAR(state.acceleration[0](0), motion.acceleration, 1e-13);
      }
    }
}

// What follows from the forces on the others alone: the same on every way, up to the 1e-4 of strains and rotations that
// tell small from finite kinematics.
TEST(HeldBlocks, ShakeTheOthersTheSameOnEveryWay) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    const Stage small = stage_of(generalized_alpha_integrator(0.8), 1e-3, 60);
    Simulation linear = simulation_of(shaken_bar(bond(law), small));
    Simulation general = simulation_of(shaken_bar(strong(law), small));
    ASSERT_TRUE(linear.plan().linear);
    ASSERT_FALSE(general.plan().linear);
    run(linear, 60);
    run(general, 60);
    for (std::size_t block : {1U, 2U}) {
      const double scale = linear.state().displacement[block].norm();
      EXPECT_GT(scale, 1e-4);
      EXPECT_LT((linear.state().displacement[block] - general.state().displacement[block]).norm(), 1e-10 * scale);
    }
  }
}

// A block on supports k gives way by F/k; in the limit it is a held one. (Strains as well: supports at four corners.)
TEST(HeldBlocks, AreTheLimitOfStiffSupports) {
  const Stage stage = stage_of(trapezoidal_integrator(), 1e-3, 40);
  Simulation held = simulation_of(shaken_bar(bond(InterfaceLaw::classical), stage));
  run(held, 40);
  std::vector<double> differences;
  for (const double stiffness : {1e12, 1e13}) {
    Model model = bar_of(3, bond(InterfaceLaw::classical));
    for (const Vec2& corner : model.blocks[0].shape.outer) {
      PointSupport support{0, corner, true, true, stiffness, {1, -0.5}, ground_motion()};
      support.kind = MotionKind::acceleration;
      model.supports.push_back(support);
    }
    model.stages = {stage};
    Simulation supported = simulation_of(std::move(model));
    run(supported, 40);
    differences.push_back((supported.state().displacement[2] - held.state().displacement[2]).norm());
  }
  EXPECT_LT(differences[0], 1e-3 * held.state().displacement[2].norm());
  EXPECT_NEAR(differences[0] / differences[1], 10, 0.5);
}

// The work of the base is all that comes in.
TEST(HeldBlocks, EnergyBalances) {
  for (const Integrator& integrator : dynamic_integrators())
    for (const Way& way : ways()) {
      Model model = shaken_bar(way.joint, stage_of(integrator, 1e-3, 70, way.kinematics));
      model.gravity = {0, -10};
      model.point_loads = {{2, {3, 0.4}, {1e4, 2e4}, SineCycles{30, 2, 0}}};
      Simulation simulation = simulation_of(std::move(model));
      run(simulation, 70);
      // Far more than the residual allowed, so that it would be missed.
      EXPECT_GT(std::abs(simulation.energy().external_work), 1e-5 * simulation.energy().scale());
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11) << integrator.name;
    }
}

// A block rides on a base that turns, and the base takes what the weight brings, 3 m down, less the kinetic energy.
// Rows of one moment miss 1/2 turn^2 of a step times the distance of the centroids, by which the forces of stiff joints
// jumped at the start of every step; their work was in that of the base, 0.1 to 1.2 % too much in blocks as soft as
// these.
TEST(HeldBlocks, WorkOfOneThatTurnsIsThatOfTheForcesInBalance) {
  JointMaterial dry;
  dry.law = InterfaceLaw::projected;
  dry.friction_angle = 0.6;
  for (const JointMaterial& joint : {dry, bond(InterfaceLaw::consistent)})
    for (const Integrator& integrator : {generalized_alpha_integrator(0), generalized_alpha_integrator(0.5)}) {
      Model model;
      model.materials = {rock()};
      model.joints = {joint};
      model.blocks = {rectangle("base", -20, -1, 40, 1), rectangle("rider", 9, 0, 2, 1)};
      HeldBlock base;
      base.turn = -0.2;
      base.kind = MotionKind::velocity;
      base.history = PiecewiseLinear{{0, 1, 2, 3}, {0, 1, 1, 1}};
      model.held_blocks = {base};
      model.gravity = {0, -9.81};
      model.stages = {stage_of(static_integrator(), 0, 1, Kinematics::finite),
                      stage_of(integrator, 2e-3, 1000, Kinematics::finite)};
      model.stages[0].equilibrium = 1e-9;
      Simulation simulation = simulation_of(std::move(model));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      const EnergyLedger& energy = simulation.energy();
      EXPECT_NEAR(energy.external_work / (energy.kinetic - energy.gravity_work), 1, 3e-4)
          << integrator.name << " " << simulation.energy().numerical;
      EXPECT_LT(std::abs(energy.relative_residual()), 1e-11);
    }
}

TEST(HeldBlocks, CountNeitherForKineticEnergyNorForBalance) {
  Model model = shaken_bar(bond(InterfaceLaw::consistent), stage_of(trapezoidal_integrator(), 1e-3, 10));
  model.held_blocks = {shaken(0), shaken(1), shaken(2)};
  model.gravity = {0, -10};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 10);
  EXPECT_EQ(simulation.energy().kinetic, 0);
  EXPECT_EQ(simulation.out_of_balance(), 0);
}

// Random paths of a heavy base under a block: the weight of the base is no part of the energies, nor of what loads and
// motions are compared with, whatever step the scene takes.
TEST(HeldBlocks, WeightOfMovingOnesIsInNoEnergy) {
  std::mt19937 random(58);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int scene = 0; scene < 24; ++scene)
    for (const Way& way : ways()) {
      const std::vector<Integrator> integrators = dynamic_integrators();
      const Integrator& integrator = integrators[static_cast<std::size_t>(scene) % integrators.size()];
      Model model = shaken_bar(way.joint, stage_of(integrator, 1e-3, 70, way.kinematics));
      model.materials.push_back(model.materials[0]);
      model.materials[1].density *= 1e4;  // the work of its weight would be all there is
      model.blocks[0].material = 1;
      model.held_blocks[0].amplitude = {3 * number(random), 3 * number(random)};
      if (way.kinematics == Kinematics::finite) model.held_blocks[0].turn = number(random);
      model.gravity = {5 * number(random), -10};
      model.point_loads = {{2, {3, 0.4}, {1e4 * number(random), 1e4 * number(random)}, SineCycles{30, 2, 0}}};
      finish_model(model);
      Simulation simulation(model);
      double fallen = 0;
      while (!simulation.finished()) {
        const State before = simulation.state();
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        for (std::size_t i = 1; i < 3; ++i)
          fallen += model.mass_of(static_cast<int>(i)) *
                    model.gravity.dot((simulation.state().displacement[i] - before.displacement[i]).head<2>());
      }
      const EnergyLedger& energy = simulation.energy();
      EXPECT_NEAR(energy.gravity_work, fallen, 1e-9 * std::abs(fallen)) << scene;
      // This is round-off in rows of three blocks; forces of a base 10^4 times as heavy would spoil four digits more.
      EXPECT_LT(std::abs(energy.relative_residual()), 1e-10) << scene << integrator.name;
    }
}

// A stack settles on a held floor to its weight in static steps, and the floor stays where it is.
TEST(HeldBlocks, CarryWhatRestsOnThem) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("floor", -1, -1, 3, 1), rectangle("block", 0, 0, 1, 0.5)};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -10};
  model.stages = {stage_of(static_integrator(), 1e-2, 60, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 60);
  EXPECT_EQ(simulation.state().displacement[0], Vec6::Zero());
  double carried = 0;
  for (const InterfaceState& state : simulation.contacts().states) carried -= state.force(0);
  const double weight = 2600 * 0.5 * 10;
  EXPECT_NEAR(carried, weight, 1e-6 * weight);
  EXPECT_LT(simulation.out_of_balance(), 1e-6);
}

// A floor is tilted slowly about a far point: the block on it stays until the slope reaches the friction angle.
TEST(HeldBlocks, TiltingTable) {
  for (const double share : {0.98, 1.02}) {
    Model model;
    model.materials = {rock()};
    model.blocks = {rectangle("floor", -4, -1, 8, 1), rectangle("block", 0, 0, 1, 0.5)};
    model.joints = {JointMaterial{}};
    model.joints[0].friction_angle = 0.3;
    HeldBlock table;
    table.turn = share * 0.3;
    table.about = {-4, -1};
    table.history = PiecewiseLinear{{0.5, 2.5}, {0, 1}};
    model.held_blocks = {table};
    model.gravity = {0, -10};
    model.stages = {stage_of(static_integrator(), 1e-2, 400, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 400);
    EXPECT_NEAR(simulation.state().displacement[0](2), share * 0.3, 1e-15);
    const Vec2 along = Vec2(std::cos(share * 0.3), std::sin(share * 0.3));
    const Vec2 drawn(0.5, 0.25);
    const Vec2 now = current_centroid(simulation.model(), simulation.state(), 1);
    const double slid = along.dot(now - Vec2(-4, -1)) - (drawn - Vec2(-4, -1)).x();
    // Held: within a step turns are linear, which at the edge's 0.5 m takes half the turn of a step (1.5e-3) of the
    // whole turn (0.3): 1.1e-4 m. Sliding in static steps: g (sin a - cos a tan f) dt^2/2 = 3.1e-6 m in each of the 150
    // steps at full tilt, 4.7e-4 m in all, less the 1.1e-4 m above.
    if (share < 1) {
      EXPECT_LT(std::abs(slid), 1.2e-4);
    } else {
      EXPECT_LT(slid, -3e-4);
    }
  }
}

// Stacks of cubes on a base that is turned in one static stage that finds its own steps ride along until they tip at
// atan(1/n), since the friction angle is 45 degrees. Each part of the turn takes them off the base by more than their
// weight compresses them: with friction given by what touches nothing they slid by 3 cm, and far turns were not over
// when the stage was.
TEST(HeldBlocks, CarryStacksThroughFarTurns) {
  for (const int cubes : {1, 2, 3})
    for (const double share : {0.1, 0.3, 0.5, 0.7}) {
      Model model;
      model.materials = {{"stone", 2400, 20e9, 0.2, PlaneState::stress}};
      model.blocks = {rectangle("base", -3, -1, 7, 1)};
      for (int i = 0; i < cubes; ++i) model.blocks.push_back(rectangle(fmt::format("cube {}", i), 0, i, 1, 1));
      JointMaterial joint;
      joint.law = InterfaceLaw::projected;
      joint.friction_angle = std::numbers::pi / 4;
      model.joints = {joint};
      HeldBlock base;
      base.turn = share * std::atan(1.0 / cubes);
      base.about = {0, 0};
      base.history = PiecewiseLinear{{0, 1}, {0, 1}};
      model.held_blocks = {base};
      model.gravity = {0, -9.81};
      Stage stage = stage_of(static_integrator(), 0, 0, Kinematics::finite);
      stage.equilibrium = 1e-9;
      model.stages = {stage, stage};
      model.stages[1].duration = 1;
      Simulation simulation = simulation_of(std::move(model));
      while (!simulation.finished())
        ASSERT_EQ(simulation.step(), Status::ok) << cubes << ", " << share << ": " << simulation.message();
      for (int i = 0; i < cubes; ++i) {
        const Vec2 now = current_centroid(simulation.model(), simulation.state(), 1 + i);
        const Vec2 ridden = Eigen::Rotation2Dd(base.turn) * Vec2(0.5, i + 0.5);
        // What the stone gives way, and slips that each part of the turn may leave: at most 5e-5 m as measured.
        EXPECT_LT((now - ridden).norm(), 1.5e-4) << cubes << ", " << share;
      }
    }
}

// A static stage that finds its own steps takes no time and has no histories: what moves goes straight to where it is
// to be. A block that is dragged along a wall of friction has slid by that way, however often its base would have come
// and gone, and is pulled the way that it goes.
TEST(HeldBlocks, GoStraightInStagesThatFindTheirSteps) {
  constexpr double way = 0.02, push = 1e5, friction = 0.5;
  for (const double between : {0.5, 1.5, 5.0, -2.0}) {
    Model model;
    model.materials = {rock()};
    JointMaterial joint;
    joint.law = InterfaceLaw::classical;
    joint.friction_angle = std::atan(friction);
    model.joints = {joint};
    model.blocks = {rectangle("base", -1, -1, 3, 1), rectangle("box", 0, 0, 1, 0.2)};
    HeldBlock base;
    base.amplitude = {way, 0};
    base.history = PiecewiseLinear{{0, 1, 1.4, 2}, {0, 0, between, 1}};
    model.held_blocks = {base};
    for (const Vec2& corner : {Vec2(1, 0), Vec2(1, 0.2)})
      model.supports.push_back({1, corner, true, false, 1e11, Vec2::Zero(), Constant{}});
    model.edge_loads = {{1, {1, 0.2}, {0, 0.2}, {0, -push}, Constant{}}};
    Stage stage = stage_of(static_integrator(), 0, 1, Kinematics::small);
    stage.duration = 1;
    stage.equilibrium = 1e-6;
    model.stages = {stage, stage};
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    double pull = 0;
    for (const SupportElement& support : simulation.system().supports) pull -= (support.stiffness * support.gap).x();
    EXPECT_NEAR(pull, -friction * push, 1e-4 * push) << between;
    EXPECT_NEAR(simulation.energy().friction, friction * push * way, 0.03 * friction * push * way) << between;
  }
}

TEST(HeldBlocks, BadOnes) {
  const auto refused = [](auto spoil) {
    Model model = shaken_bar(bond(InterfaceLaw::consistent), stage_of(trapezoidal_integrator(), 1e-3, 1));
    spoil(model);
    EXPECT_ANY_THROW(finish_model(model));
  };
  refused([](Model& m) { m.held_blocks[0].block = 3; });
  refused([](Model& m) { m.held_blocks.emplace_back(); });  // held, and moved
  refused([](Model& m) { m.blocks[0].initial_spin = 1; });
  refused([](Model& m) { m.held_blocks[0].turn = 1; });  // small kinematics
  refused([](Model& m) { m.viscous_edges = {{0, {0, 0}, {0, 0.8}, 1, 1}}; });
  refused([](Model& m) { m.held_blocks[0].amplitude.x() = std::nan(""); });
}

// A held block has no stress of its own that a mean could be taken with.
TEST(HeldBlocks, ConsistentJointWithOneCarriesTheStressOfTheOther) {
  Material straight = rock();
  straight.poisson = 0;
  for (const JointMaterial& joint : {bond(InterfaceLaw::consistent), strong(InterfaceLaw::consistent)}) {
    Model model = bar_of(3, joint, straight);
    model.held_blocks = {HeldBlock{}};
    model.edge_loads = {{2, {3, 0}, {3, 0.8}, {-1e5, 0}, Constant{}}};
    model.stages = {stage_of(static_integrator(), 10, 20)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 20);
    for (const std::size_t block : {1U, 2U}) EXPECT_NEAR(simulation.state().stress[block](0), -1e5, 1e-3) << block;
    const double end = point_displacement(simulation.model(), simulation.state(), 2, {3, 0.4}).x();
    EXPECT_NEAR(end, -1e5 * 2 / straight.young, 1e-9 * 2e-4);
  }
}

// All of the stress on both gaps asks for twice the penalty that a mean would: `penalty` keeps its bound of 1.
TEST(HeldBlocks, ConsistentJointsWithThemAreStableAtTheirLowestPenalty) {
  Model model = bar_of(3, bond(InterfaceLaw::consistent));
  model.joints[0].penalty = 1.05;
  model.held_blocks = {HeldBlock{}, HeldBlock{}};
  model.held_blocks[1].block = 2;
  model.point_loads = {{1, {1.5, 0.4}, {1e4, 0}, Constant{}}};
  model.stages = {stage_of(static_integrator(), 10, 20)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 20);
  EXPECT_LT(simulation.out_of_balance(), 1e-9);
  EXPECT_GT(simulation.state().displacement[1](0), 0);
}

}  // namespace
}  // namespace dda
