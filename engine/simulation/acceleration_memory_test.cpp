// Two free blocks that meet head-on, by lot: no faster apart than together, whatever the length of steps.
#include "engine/simulation/acceleration_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

Ring turned(Ring ring, double angle) {
  for (Vec2& vertex : ring) vertex = rotation(angle) * vertex;
  return ring;
}

struct Pair {
  double height, length_a, length_b, gap, turn, speed, dt;
  FirstSteps first;

  [[nodiscard]] Simulation thrown() const {
    Model model = model_of({{turned(box_ring(-length_a, 0, 0, height), turn), {}},
                            {turned(box_ring(gap, 0, gap + length_b, height), turn), {}}},
                           {"rock", 2600, 20e9, 0.25, PlaneState::stress});
    model.joints[0].law = InterfaceLaw::classical;
    model.joints[0].friction_angle = 0.5;
    model.blocks[0].initial_velocity = rotation(turn) * Vec2(speed, 0);
    model.stages = {stage_of(generalized_alpha_integrator(0), dt, 60, Kinematics::finite)};
    model.stages[0].chosen.dt.first_steps = first;
    model.stages[0].duration += first.duration();
    return simulation_of(std::move(model));
  }
};

double speed_apart(const Simulation& simulation, double turn) {
  const State& state = simulation.state();
  const Vec2 apart = state.velocity[1].head<2>() - state.velocity[0].head<2>();
  return apart.dot(rotation(turn) * Vec2(1, 0));
}

template <typename Number>
Pair pair_by_lot(const Number& number) {
  Pair pair{};
  pair.height = std::pow(10, number(-2, 1));
  pair.length_a = pair.height * number(0.5, 3);
  pair.length_b = pair.height * number(0.5, 3);
  return pair;
}

// They fly apart no faster than they have met. Elastic blocks keep some of the energy, so 1 is the most; the first part
// of a step moves them by up to its closure of springs, 1e-3 of what they travel in it.
void expect_no_gain(const Pair& pair, int scene, double& fastest) {
  Simulation simulation = pair.thrown();
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << scene;
  const double restitution = speed_apart(simulation, pair.turn) / pair.speed;
  EXPECT_LE(restitution, 1 + 1e-3) << "scene " << scene << ", dt " << pair.dt;
  EXPECT_GT(restitution, -1e-9) << "scene " << scene << ": passed through, or never met";
  fastest = std::max(fastest, restitution);
}

// A step is up to a thousand times as long as a wave takes through a block, so that most impacts lie within one part of
// one step.
TEST(AccelerationMemory, BlocksFlyApartNoFasterThanTheyHaveMet) {
  std::mt19937 random(31);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double fastest = 0;
  for (int scene = 0; scene < 200; ++scene) {
    Pair pair = pair_by_lot(number);
    pair.turn = scene % 2 == 0 ? 0 : number(-3, 3);
    pair.dt = pair.height / 2800 * std::pow(10, number(0, 3));
    pair.speed = 0.01 * pair.height / pair.dt * number(0.05, 1);  // up to a hundredth of the block in a step
    pair.gap = pair.speed * pair.dt * number(3, 8);
    ASSERT_NO_FATAL_FAILURE(expect_no_gain(pair, scene, fastest));
  }
  EXPECT_GT(fastest, 0.5);  // or nothing has met
}

// They meet in one of the last steps before these grow.
TEST(AccelerationMemory, BlocksFlyApartNoFasterThanTheyHaveMetWhereStepsGrow) {
  std::mt19937 random(32);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  double fastest = 0;
  for (int scene = 0; scene < 200; ++scene) {
    Pair pair = pair_by_lot(number);
    pair.first = {pair.height / 2800 * std::pow(10, number(0, 2.5)), 1 + scene % 3};
    pair.dt = std::ldexp(pair.first.dt, pair.first.doublings);
    pair.speed = 0.01 * pair.height / pair.dt * number(0.05, 1);  // up to a hundredth of the block in a step
    const std::int64_t grows = 100 * (2 + scene % pair.first.doublings);
    pair.gap = pair.speed * (pair.first.time_of(grows) - pair.first.dt_of(grows - 1) * number(0, 3));
    ASSERT_NO_FATAL_FAILURE(expect_no_gain(pair, scene, fastest));
  }
  EXPECT_GT(fastest, 0.5);  // or nothing has met
}

// Regular polygons fly at a middle from all sides, by lot, and meet there in twos and threes.
Simulation swarm(std::mt19937& random) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const int blocks = std::uniform_int_distribution(3, 6)(random);
  std::vector<Polygon> shapes;
  std::vector<Vec2> ways;
  for (int i = 0; i < blocks; ++i) {
    const Vec2 outwards = rotation(2 * std::numbers::pi * (i + number(0.3, 0.7)) / blocks) * Vec2(1, 0);
    const int corners = std::uniform_int_distribution(3, 7)(random);
    const double radius = number(0.2, 0.7), turn = number(0, 3);
    Ring ring;
    for (int corner = 0; corner < corners; ++corner)
      ring.push_back(2 * outwards + radius * (rotation(turn + 2 * std::numbers::pi * corner / corners) * Vec2(1, 0)));
    shapes.push_back({ring, {}});
    ways.push_back(-number(1, 5) * outwards);
  }
  Model model = model_of(shapes, {"rock", 2600, 20e9, 0.2, PlaneState::stress});
  model.joints[0].law = InterfaceLaw::classical;
  model.joints[0].friction_angle = number(0, 0.6);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    model.blocks[i].initial_velocity = ways[i];
    model.blocks[i].initial_spin = number(-1, 1);
  }
  model.stages = {stage_of(generalized_alpha_integrator(0), 2e-3, 500, Kinematics::finite)};
  return simulation_of(std::move(model));
}

Vec2 momentum_of(const Simulation& simulation) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    sum += simulation.model().mass_of(static_cast<int>(i)) * simulation.state().velocity[i].head<2>();
  return sum;
}

// Nothing acts on them from outside. Steps are cut at impacts, and some blocks have left others only just: what these
// have given each other counts as well. It was up to 1 % of the sum of m |v|, in a fifth of the scenes.
TEST(AccelerationMemory, BlocksThatMeetKeepTheirMomentum) {
  std::mt19937 random(4);
  for (int scene = 0; scene < 40; ++scene) {
    Simulation simulation = swarm(random);
    const Vec2 before = momentum_of(simulation);
    double all = 0;
    for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
      all += simulation.model().mass_of(static_cast<int>(i)) * simulation.state().velocity[i].head<2>().norm();
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << scene << ": " << simulation.message();
    EXPECT_LT((momentum_of(simulation) - before).norm(), 1e-9 * all) << scene;  // round-off of 500 steps
  }
}

// Blocks 0 and 1 touch or not; block 2 is far away.
ContactSet touching(ContactStatus status) {
  ContactSet contacts;
  InterfaceElement element;
  element.stiffness.setZero();
  element.rows_a.setZero();
  element.rows_b.setZero();
  for (Mat43* rows : {&element.stress_rows_a, &element.stress_rows_b, &element.strain_rows_a, &element.strain_rows_b})
    rows->setZero();
  element.block_a = 0;
  element.block_b = 1;
  InterfaceState state;
  state.status = {status, ContactStatus::open};
  contacts.elements.edit() = {element};
  contacts.states = {state};
  return contacts;
}

const std::vector<Inertia> three_masses(3, {.mass = 1, .squares = Vec3(1, 1, 0)});

TEST(AccelerationMemory, WhatAnImpactHasGainedShrinksAsStepsGrow) {
  const Vec6 before = Vec6::Constant(-9.81);
  std::vector<Vec6> now(3, before);
  const ContactSet apart = touching(ContactStatus::open), closed = touching(ContactStatus::locked);
  AccelerationMemory memory;
  std::vector<Inertia> inertia = three_masses;
  inertia[1].mass = 0;  // held
  memory.begin(inertia, apart, now);
  memory.begin_part(1e-3, now);
  memory.end_part(1e-3, closed);
  for (Vec6& block : now) {
    block(0) -= 8;
    block(2) -= 2;
  }
  memory.begin_part(2e-3, now);
  EXPECT_DOUBLE_EQ(now[0](0), before(0) - 4);
  EXPECT_EQ(now[0](1), before(1));
  EXPECT_DOUBLE_EQ(now[0](2), before(2) - 1);
  EXPECT_EQ(now[2](0), before(0) - 8) << "nothing hit it";
  memory.take_back(now);  // a part that failed has changed nothing
  EXPECT_EQ(now[0](0), before(0) - 8);
  memory.begin_part(1e-3, now);
  EXPECT_EQ(now[0](0), before(0) - 8) << "as long as the part before";
  memory.end_part(1e-3, closed);
  memory.end(8e-3, now);
  EXPECT_DOUBLE_EQ(now[0](0), before(0) - 1);
  EXPECT_EQ(now[2](0), before(0) - 8);
}

// What two free blocks have gained against each other shrinks, and what both have gained stays.
TEST(AccelerationMemory, TheMeanOfFreeBlocksStaysAsItIs) {
  std::vector<Vec6> now(3, Vec6::Zero());
  AccelerationMemory memory;
  memory.begin(three_masses, touching(ContactStatus::open), now);
  memory.begin_part(1e-3, now);
  memory.end_part(1e-3, touching(ContactStatus::locked));
  now[0](0) = 5;
  now[1](0) = -3;
  memory.end(2e-3, now);
  EXPECT_DOUBLE_EQ(now[0](0), 1 + 2);
  EXPECT_DOUBLE_EQ(now[1](0), 1 - 2);
}

// An octagon that turns so fast that each step of 5 ms is cut, 30 m away from all else.
void add_far_wheel(Model& model) {
  Ring ring;
  for (int i = 0; i < 8; ++i) ring.push_back(Vec2(30, 0) + 0.2 * (rotation(i * std::numbers::pi / 4) * Vec2(1, 0)));
  Block wheel;
  wheel.name = "wheel";
  wheel.shape.outer = ring;
  wheel.initial_spin = 60;
  model.blocks.push_back(wheel);
}

Model lone_block() {
  Model model = model_of({{box_ring(0, 0, 1, 1), {}}}, {"rock", 2600, 20e9, 0.25, PlaneState::stress});
  model.joints[0].law = InterfaceLaw::classical;
  return model;
}

// A triangular pulse pushes a free block to impulse over mass; the steps that a far block needs are none of its own.
TEST(AccelerationMemory, AFarBlockThatNeedsShortStepsTakesNoMomentumFromOthers) {
  for (const double pulse : {0.02, 0.05, 0.2}) {
    Model model = lone_block();
    add_far_wheel(model);
    model.point_loads.push_back({0, {0.5, 0.5}, {33e3, 0}, PiecewiseLinear{{0, pulse / 2, pulse}, {0, 1, 0}}});
    model.stages = {stage_of(generalized_alpha_integrator(0), 0.005, 100, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double expected = 33e3 * pulse / 2 / 2600;
    EXPECT_NEAR(simulation.state().velocity[0](0), expected, 1e-6 * expected) << pulse;
  }
}

// A block on two springs swings at 32 rad/s: damped by these integrators, or not, and never driven.
TEST(AccelerationMemory, AFarBlockThatNeedsShortStepsDrivesNoOscillation) {
  constexpr double missed = 0.16 * 0.16 / 8;  // of a peak that lies between steps, which turn the phase by 0.16 rad
  for (const Integrator& integrator :
       {generalized_alpha_integrator(0), generalized_alpha_integrator(0.5), hht_integrator(0.3)}) {
    Model model = lone_block();
    add_far_wheel(model);
    for (const double x : {0.0, 1.0}) {
      PointSupport support;
      support.block = 0;
      support.point = {x, 0};
      support.stiffness = 1.3e6;
      model.supports.push_back(support);
    }
    model.blocks[0].initial_velocity = {0, 1};
    model.stages = {stage_of(integrator, 0.005, 400, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    double fastest_early = 0, fastest_late = 0;
    for (int step = 0; !simulation.finished(); ++step) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      double& fastest = step < 100 ? fastest_early : fastest_late;
      if (step < 100 || step >= 300) fastest = std::max(fastest, std::abs(simulation.state().velocity[0](1)));
    }
    EXPECT_GT(fastest_early, 0.9);
    EXPECT_LE(fastest_late, fastest_early * (1 + missed)) << integrator.name;
  }
}

// What a block is driven by is known, whatever its neighbours' steps.
TEST(AccelerationMemory, ABlockThatIsDrivenHasTheAccelerationOfItsDrive) {
  Model model = lone_block();
  add_far_wheel(model);
  HeldBlock held;
  held.block = 0;
  held.kind = MotionKind::acceleration;
  held.amplitude = {1, 0};
  held.history = SineCycles{.frequency = 2};
  model.held_blocks = {held};
  model.stages = {stage_of(generalized_alpha_integrator(0), 0.005, 100, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok);
    const double time = simulation.state().time;
    EXPECT_NEAR(simulation.state().acceleration[0](0), std::sin(4 * std::numbers::pi * time), 1e-9) << time;
  }
}

// A block that turns has all of its steps cut, and what an early push has left in its accelerations must fade all the
// same: without loads it keeps its spin. Pushed for 50 ms, and looked at from 1 s to 5 s.
TEST(AccelerationMemory, ABlockThatWasPushedDoesNotGoOnToSpinUp) {
  for (const double force : {5e3, 50e3}) {
    Model model = model_of({{box_ring(0, 0, 1, 1), {}}}, {"rock", 2600, 20e9, 0.25, PlaneState::stress});
    model.joints[0].law = InterfaceLaw::classical;
    model.point_loads.push_back({0, {1, 1}, {0, force}, PiecewiseLinear{{0, 0.05, 0.0500001}, {1, 1, 0}}});
    model.stages = {stage_of(generalized_alpha_integrator(0), 0.05, 100, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    double early = 0;
    for (int step = 0; !simulation.finished(); ++step) {
      ASSERT_EQ(simulation.step(), Status::ok);
      if (step == 20)
        early = simulation.state().velocity[0](2);  // what the push has left has gone by half in each part
    }
    EXPECT_GT(early, 0.1);
    EXPECT_NEAR(simulation.state().velocity[0](2), early, 1e-3 * early) << force;  // 2e-5 of an initial spin is lost
  }
}

}  // namespace
}  // namespace dda
