// Blocks that a step moves further than contacts are usually looked for, and stages that start with light blocks
// pressed between stiff ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "engine/simulation/block_system.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/settling_cushion.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;

// A held floor, and above it a loose stone of the given size.
Model stone_over_floor(double size, double height) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -2, -1, 4, 1), rectangle("stone", -size / 2, height, size, size)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -standard_gravity};
  return model;
}

// Free fall over a static step of 1 s would be 5 m, a hundred times the stone: with its drag it finds the floor.
TEST(Settling, LooseStoneComesToLieOnTheFloor) {
  Model model = stone_over_floor(0.05, 0.002);
  model.stages = {stage_of(static_integrator(), 1, 200, Kinematics::finite)};
  model.stages[0].equilibrium = 1e-9;
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LT(simulation.results().out_of_balance[0], 1e-9);
  // On the floor but for what springs of the automatic stiffness give way under rho g h = 1.3 kPa.
  EXPECT_NEAR(simulation.state().displacement[1](1), -0.002, 1e-7);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

// Four boxes of 1 m around a point. Two of them leave while the other two go at each other over the corner, which a
// third block covers as long as all four lie there: in one step they go 40 mm.
TEST(Settling, CornersThatAStepUncoversMeet) {
  for (const int steps : {2, 20}) {
    Model model;
    model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
    model.joints = {JointMaterial{}};
    model.blocks = {rectangle("upper left", -1, 0, 1, 1), rectangle("upper right", 0, 0, 1, 1),
                    rectangle("lower left", -1, -1, 1, 1), rectangle("lower right", 0, -1, 1, 1)};
    model.held_blocks.emplace_back().block = 3;
    model.blocks[0].initial_velocity = {1, -1};
    model.blocks[1].initial_velocity = {2, 2};
    model.blocks[2].initial_velocity = {-2, -2};
    model.stages = {stage_of(generalized_alpha_integrator(0), 0.08 / steps, steps, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, steps);
    const Vec2 moved = current_position(simulation.model(), simulation.state(), 0, {0, 0});
    // Its corner has passed on one side or the other, but for what sides in line may differ.
    EXPECT_LT(std::min(moved.x(), -moved.y()), 1e-3) << steps << ": " << moved.transpose();
  }
}

// In one step the stone moves by ten times its size, and by a hundred times what contacts are usually looked for from.
// Gaps are differences of coordinates of 0.1 m, and what springs make of their round-off acts on a way of ten sizes,
// beside a kinetic energy that goes by size^4. Of 200 heights the worst was 4.4e-13, 8.9e-10 and 5.5e-8.
TEST(Settling, FastStoneIsStoppedByWhatItWouldPassInOneStep) {
  for (const double size : {1e-1, 1e-2, 1e-3})
    for (const double height : {0.1, 0.1007, 0.114, 0.125, 0.1693, 0.2}) {
      Model model = stone_over_floor(size, height);
      model.blocks[1].initial_velocity = {0, -10 * size / 1e-3};
      model.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 100, Kinematics::finite)};
      Simulation simulation = simulation_of(std::move(model));
      run(simulation, 100);
      EXPECT_GT(simulation.state().displacement[1](1), -height - 0.1 * size) << size;
      const EnergyLedger& energy = simulation.energy();
      EXPECT_LE(energy.kinetic, energy.initial.kinetic + energy.gravity_work) << size;
      EXPECT_LT(std::abs(energy.relative_residual()), 2e-15 / std::pow(size, 3)) << size << ", " << height;
    }
}

// A pebble wedged between blocks, whose shear of a stage of unlimited strength is let go at its end: the pebble's
// unbalanced force over its mass, times dt, would be a velocity of some hundred metres a second.
TEST(Settling, LetGoShearOfLightBlocksBringsNoEnergy) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.02;
  Block wedge;
  wedge.name = "wedge";
  wedge.shape.outer = {{0, 0}, {3, 1.5}, {0, 1.5}};
  Block pebble;
  pebble.name = "pebble";
  pebble.shape.outer = {{-0.01, 0.5}, {0, 0.5}, {0, 0.51}, {-0.01, 0.51}};
  Block floor;
  floor.name = "floor";
  floor.shape.outer = {{0, 0}, {0, -1}, {5, -1}, {5, 2.5}};
  model.blocks = {floor, wedge, rectangle("wall", -1.01, -1, 1, 3), pebble};
  for (const int held : {0, 2}) model.held_blocks.emplace_back().block = held;
  model.gravity = {0, -standard_gravity};
  Stage settle = stage_of(static_integrator(), 1, 20, Kinematics::finite);
  settle.unlimited_strength = true;
  model.stages = {settle, stage_of(generalized_alpha_integrator(0), 1e-3, 5, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 20);
  const double stored = simulation.energy().strain + simulation.energy().contact;
  const double fallen = simulation.energy().gravity_work;
  run(simulation, 5);
  const EnergyLedger& energy = simulation.energy();
  EXPECT_LT(energy.kinetic, stored + energy.gravity_work - fallen);
}

Stage settling() {
  Stage stage = stage_of(static_integrator(), 0, 0, Kinematics::finite);
  stage.equilibrium = 1e-9;
  return stage;
}

// A sliver squeezed between three blocks of which one is taken away: where its ends slide nothing but its own stiffness
// keeps it from being squeezed out within far less than a step. (Seed 125 of `dda-verify rocks`: 1.7 m/s after a motion
// of 0.01 mm in 1 ms, 4 % of the energy of the rock.)
TEST(Settling, SqueezedSliversThatAreLetGoBringNoEnergy) {
  std::mt19937 generator(1);
  const auto number = [&](double lower, double upper) {
    return std::uniform_real_distribution(lower, upper)(generator);
  };
  for (int i = 0; i < 40; ++i) {
    const Vec2 left(0, 0), right(0.1, 0), tip(number(0, 0.1), -number(0.005, 0.05)), low(tip / -tip.y());
    Block sliver, west, east;
    sliver.shape.outer = {left, tip, right};
    west.shape.outer = {{-1, 0}, {-1, -1}, low, left};
    east.shape.outer = {tip, low, {low.x() + 2, -1}, {low.x() + 2, 0}, right};
    Model model;
    model.materials = {{"rock", 2100, 49e9, 0.2, PlaneState::stress}};
    model.joints = {JointMaterial{}};
    model.joints[0].friction_angle = number(0.1, 0.7);
    model.blocks = {sliver,
                    west,
                    east,
                    rectangle("plug", -1, 0, 3, 1),
                    rectangle("lid", -1, 1, 3, 1),
                    rectangle("left", -2, 0, 1, 1),
                    rectangle("right", 2, 0, 1, 1)};
    for (Block& block : model.blocks) block.initial_stress = {-1e5, -3e5, number(-1e5, 1e5)};
    for (const int held : {1, 2, 4, 5, 6}) model.held_blocks.emplace_back().block = held;
    model.stages = {settling(), stage_of(generalized_alpha_integrator(0), 1e-3, 3, Kinematics::finite)};
    model.stages[1].removal.blocks = {3};
    Simulation simulation = simulation_of(std::move(model));
    while (stages_done(simulation) == 0) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double stored = simulation.energy().strain + simulation.energy().contact;
    while (!simulation.finished()) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      EXPECT_LT(simulation.energy().kinetic, stored) << i;
    }
  }
}

// Bricks of 0.5 x 0.25 m in a running bond on a held floor, whose foot shears outwards under the weight: with little
// friction bricks of the foot slide until the rest holds them.
Model wall(int rows, double friction_angle) {
  Model model;
  model.materials = {{"brick", 1900, 10e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = friction_angle;
  model.blocks = {rectangle("floor", -1, -1, 6, 1)};
  model.held_blocks.emplace_back().block = 0;
  for (int row = 0; row < rows; ++row)
    for (double left = row % 2 == 0 ? 0 : -0.25; left < 4; left += 0.5) {
      const double begin = std::max(left, 0.0);
      model.blocks.push_back(rectangle("brick " + std::to_string(model.blocks.size()), begin, 0.25 * row,
                                       std::min(left + 0.5, 4.0) - begin, 0.25));
    }
  model.gravity = {0, -standard_gravity};
  return model;
}

double foot_force(const Simulation& simulation) {
  double force = 0;
  const ContactSet& contacts = simulation.contacts();
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (contacts.elements[i].block_a == 0 || contacts.elements[i].block_b == 0)
      force -= contacts.states[i].force(0) + contacts.states[i].force(2);
  return force;
}

// Without a dt, with unlimited strength and with the joints' own: no time passes, and the floor carries the weight.
TEST(Settling, WallFindsItsOwnStepsToEquilibrium) {
  for (const bool unlimited : {true, false}) {
    Model model = wall(8, 0.29);
    const std::size_t bricks = model.blocks.size() - 1;
    model.stages = {settling()};
    model.stages[0].unlimited_strength = unlimited;
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    EXPECT_EQ(simulation.state().time, 0);
    EXPECT_LE(simulation.results().out_of_balance[0], 1e-9) << unlimited;
    // Each brick may be out of balance by 1e-9 of the heaviest weight, which is that of the held floor as far as it
    // carries something.
    const double heaviest = 0.5 * 0.25 * 1900 * standard_gravity;
    const double of_floor = simulation.model().mass_of(0) * standard_gravity;
    const double largest = std::max(heaviest, std::min(of_floor, 64 * heaviest));
    EXPECT_NEAR(foot_force(simulation), 64 * heaviest, 1e-9 * largest * static_cast<double>(bricks)) << unlimited;
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << unlimited;
    EXPECT_LE(simulation.state().step, 20) << unlimited;
  }
}

// What static steps take out is no loss of time integration, behind which a later stage could gain.
TEST(Settling, WhatItTakesOutIsDamping) {
  for (const double dt : {0.0, 1.0}) {
    Model model = wall(4, 0.6);
    Stage first = settling();
    first.dt = dt;
    first.duration = 100 * dt;
    constexpr int steps = 20;
    model.stages = {first, stage_of(generalized_alpha_integrator(0), 1e-3, steps, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    while (!std::isfinite(simulation.results().out_of_balance[0])) ASSERT_EQ(simulation.step(), Status::ok);
    EXPECT_EQ(simulation.energy().numerical, 0);
    EXPECT_GT(simulation.energy().damping, 0.1 * simulation.energy().gravity_work);
    const double settled = simulation.energy().damping;
    run(simulation, steps);
    EXPECT_EQ(simulation.energy().damping, settled);
    EXPECT_LT(std::abs(simulation.energy().numerical), 1e-6 * settled);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
}

// The floor moves as well. What cushions take of the stone is the work of what they add to the matrix; slip is free. By
// hand: both ends of the stone's foot on springs k, lifted by u, take 0.3 * 2 k u^2 in a step as long as the first.
TEST(Settling, CushionsTakeTheWorkOfTheStiffnessTheyAdd) {
  Model model = stone_over_floor(1, 0);
  model.joints[0].law = InterfaceLaw::classical;
  model.stages = {settling()};
  finish_model(model);
  BlockSystem system(std::move(model));
  for (InterfaceState& state : system.contacts.states) state.broken = {true, true};  // as of contacts that move
  std::vector<int> contacts(system.contacts.elements.size());
  std::iota(contacts.begin(), contacts.end(), 0);
  const double first = first_step(system.model, system.stage(), system.contacts.can_change);
  system.coefficients.dt = first;
  SettlingCushion cushion;
  const auto work_of = [&](const Vec6& floor, const Vec6& stone) {
    system.increment.resize(12);
    system.increment << floor, stone;
    system.held.increments[0] = floor;
    return cushion.work(system, contacts);
  };
  const Vec6 lift = 1e-3 * Vec6::Unit(1);
  EXPECT_EQ(work_of(Vec6::Zero(), lift), 0);
  ASSERT_TRUE(cushion.put_in(system));
  EXPECT_FALSE(cushion.put_in(system));
  double springs = 0;
  for (const InterfaceElement& element : system.contacts.elements.own())
    springs += element.stiffness(0) + element.stiffness(2);
  ASSERT_GT(springs, 0);
  const double lifted = work_of(Vec6::Zero(), lift);
  EXPECT_NEAR(lifted, 0.3 * springs * 1e-6, 1e-12 * lifted);
  EXPECT_EQ(work_of(Vec6::Zero(), 1e-3 * Vec6::Unit(0)), 0);
  EXPECT_NEAR(work_of(lift, lift), 0, 1e-12 * lifted);

  const double both = work_of((Vec6() << 1, -2, 0.5, 1, 2, -1).finished(), (Vec6() << 2, 1, -1, 0.5, -2, 3).finished());
  BlockMatrix matrix(2, {{0, 1}});
  matrix.set_zero();
  cushion.add_to(system, contacts, matrix);
  Eigen::VectorXd force(12);
  matrix.multiply(system.increment, force);
  EXPECT_NEAR(both, force.tail<6>().dot(system.increment.tail<6>()), 1e-12 * std::abs(both));

  system.coefficients.dt = 2 * first;
  EXPECT_NEAR(work_of(Vec6::Zero(), lift), lifted / 4, 1e-12 * lifted);
  system.coefficients.dt = first / 8;
  EXPECT_NEAR(work_of(Vec6::Zero(), lift), 10 * lifted, 1e-11 * lifted) << "no firmer than three springs";
}

TEST(Settling, LinearSceneFindsItsOwnStepsToEquilibrium) {
  Model model = bar_of(10, bond(InterfaceLaw::consistent));
  model.edge_loads = {{9, {10, 0}, {10, 0.8}, {1e6, 0}, Constant{}}};
  model.held_blocks.emplace_back().block = 0;
  model.stages = {settling()};
  model.stages[0].kinematics = Kinematics::small;
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LE(simulation.results().out_of_balance[0], 1e-9);
  EXPECT_LE(simulation.state().step, 4);
  for (std::size_t i = 2; i < 10; ++i) EXPECT_NEAR(simulation.state().stress[i](0), 1e6, 1e3) << i;
}

// A stone that hangs in the air beside the wall has no equilibrium: it is named with its place, stays there while the
// wall settles, and falls freely in the stage after that.
TEST(Settling, LooseStoneIsNamedAndStopsNothing) {
  Model model = wall(4, 0.6);
  model.blocks.push_back(rectangle("stone", 4.5, 1, 0.1, 0.1));
  const std::size_t stone = model.blocks.size() - 1;
  constexpr int steps = 50;
  model.stages = {settling(), stage_of(generalized_alpha_integrator(0), 1e-3, steps, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  while (simulation.is_settling()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LE(simulation.results().out_of_balance[0], 1e-9);
  ASSERT_EQ(simulation.results().loose.size(), 1U);
  EXPECT_EQ(simulation.results().loose[0].block, static_cast<int>(stone));
  EXPECT_EQ(simulation.results().loose[0].stage, 0);
  const double height = simulation.state().displacement[stone](1);
  EXPECT_NEAR(simulation.results().loose[0].place.y(), 1.05 + height, 1e-15);
  EXPECT_GT(height, -0.06) << "held once it has gone half of its size";
  run(simulation, steps);
  // The first step of generalized-alpha 0 is exact for a constant acceleration.
  EXPECT_NEAR(simulation.state().displacement[stone](1) - height, -standard_gravity * 0.05 * 0.05 / 2, 1e-9);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

// What moves it is the floor, however far that is in its own size.
TEST(Settling, PebbleOnAFloorThatRisesIsNotLoose) {
  Model model = stone_over_floor(0.01, 0);
  model.held_blocks[0].amplitude = {0, 0.05};
  model.held_blocks[0].history = Constant{};
  model.stages = {settling()};
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_TRUE(simulation.results().loose.empty());
  EXPECT_NEAR(simulation.state().displacement[1](1), 0.05, 1e-5);
}

TEST(Settling, LastStageWithALooseBlockIsNoEquilibrium) {
  Model model = stone_over_floor(0.1, 1);
  model.stages = {settling()};
  Simulation simulation = simulation_of(std::move(model));
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok) status = simulation.step();
  EXPECT_EQ(status, Status::not_in_equilibrium);
  EXPECT_NE(simulation.message().find("\"stone\" at (0, "), std::string::npos) << simulation.message();
}

// A block on a slope steeper than its friction slides for ever, in small kinematics along the face as drawn; on one
// that is not it stays.
TEST(Settling, BlockThatSlidesDownASlopeIsNamed) {
  for (const auto& [friction_angle, kinematics] : {std::pair(0.3, Kinematics::finite),
                                                   {0.5, Kinematics::finite},
                                                   {0.3, Kinematics::small},
                                                   {0.5, Kinematics::small}}) {
    Model model = stone_over_floor(0.5, 0);
    model.joints[0].friction_angle = friction_angle;
    model.gravity = standard_gravity * Vec2(std::sin(0.4), -std::cos(0.4));
    model.stages = {settling()};
    model.stages[0].kinematics = kinematics;
    Simulation simulation = simulation_of(std::move(model));
    Status status = Status::ok;
    while (!simulation.finished() && status == Status::ok) status = simulation.step();
    EXPECT_EQ(status, friction_angle < 0.4 ? Status::not_in_equilibrium : Status::ok) << simulation.message();
    EXPECT_EQ(simulation.results().loose.size(), friction_angle < 0.4 ? 1U : 0U);
  }
}

// In the middle of a stage that paces itself, with a block found loose before.
TEST(Settling, GoesOnFromASnapshotToTheLastBit) {
  const auto scene = [] {
    Model model = wall(4, 0.29);
    model.blocks.push_back(rectangle("stone", 4.5, 1, 0.1, 0.1));
    model.stages = {settling(), stage_of(generalized_alpha_integrator(0), 1e-3, 5, Kinematics::finite)};
    finish_model(model);
    return model;
  };
  for (const int stop : {2, 20, 38}) {
    Simulation whole(scene());
    run(whole, stop);
    Simulation resumed(scene());
    restore(resumed, whole.state(), save(whole));
    while (!whole.finished()) ASSERT_EQ(whole.step(), Status::ok);
    while (!resumed.finished()) ASSERT_EQ(resumed.step(), Status::ok);
    EXPECT_EQ(whole.state().step, resumed.state().step);
    for (std::size_t i = 0; i < whole.state().displacement.size(); ++i)
      EXPECT_EQ(whole.state().displacement[i], resumed.state().displacement[i]) << stop << ", block " << i;
    EXPECT_EQ(whole.results().loose.size(), resumed.results().loose.size());
  }
}

}  // namespace
}  // namespace dda
