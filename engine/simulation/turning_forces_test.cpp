// Forces on blocks that turn, under every integrator: what rows say is what changes momentum, and what judges friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/rotation.h"
#include "engine/simulation/measured_models.h"
#include "engine/simulation/projected_models.h"
#include "engine/simulation/random_test_support.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;  // m/s2

Material stiff_rock() {
  Material material = rock();
  material.young = 5e10;
  return material;
}

std::vector<Integrator> integrators_with_forces_of_the_start() {
  return {generalized_alpha_integrator(0.85), generalized_alpha_integrator(0.5), hht_integrator(0.1),
          hht_integrator(0.3), energy_conserving_integrator()};
}

Stage stage_of_turning(const Integrator& integrator, double dt, double duration) {
  return stage_of(integrator, dt, static_cast<int>(std::lround(duration / dt)), Kinematics::finite);
}

// --- A block that swings about one point, beside the rigid pendulum ---

struct Pendulum {
  double length, height, start;  // m; rad above the position of rest, level at pi/2

  [[nodiscard]] double mass() const { return rock().density * length * height; }
  [[nodiscard]] double acceleration(double angle) const {
    const double inertia = (length * length + height * height) / 12 + length * length / 4;
    return -gravity * length / 2 * std::sin(angle) / inertia;
  }
  // What the support pulls with, N: along the block it turns it round, and across it is what weight leaves to it.
  [[nodiscard]] double pull(double angle, double spin) const {
    const double along = gravity * std::cos(angle) + spin * spin * length / 2;
    const double across = gravity * std::sin(angle) + acceleration(angle) * length / 2;
    return mass() * std::hypot(along, across);
  }
};

// By Runge and Kutta's rule in twenty steps of dt/20 each: the pull after every dt.
std::vector<double> pulls_of(const Pendulum& pendulum, double dt, int steps) {
  double angle = pendulum.start, spin = 0;
  std::vector<double> pulls;
  const double h = dt / 20;
  for (int i = 0; i < 20 * steps; ++i) {
    const double a1 = pendulum.acceleration(angle), v1 = spin;
    const double a2 = pendulum.acceleration(angle + h / 2 * v1), v2 = spin + h / 2 * a1;
    const double a3 = pendulum.acceleration(angle + h / 2 * v2), v3 = spin + h / 2 * a2;
    const double a4 = pendulum.acceleration(angle + h * v3), v4 = spin + h * a3;
    angle += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    spin += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (i % 20 == 19) pulls.push_back(pendulum.pull(angle, spin));
  }
  return pulls;
}

Model model_of(const Pendulum& pendulum) {
  Model model;
  model.materials = {stiff_rock()};
  model.gravity = {0, -gravity};
  const Vec2 along(std::sin(pendulum.start), -std::cos(pendulum.start));
  const Vec2 across = pendulum.height / 2 * Vec2(-along.y(), along.x());
  const Vec2 end = pendulum.length * along;
  Block& block = model.blocks.emplace_back();
  block.name = "pendulum";
  block.shape.outer = {-across, end - across, end + across, across};
  model.supports = {{0, {0, 0}, true, true, 1000 * stiff_rock().young, Vec2::Zero(), {}}};
  return model;
}

struct Readings {
  double off = 0;                // N, the mean of how far forces are off
  Vec2 impulse = Vec2::Zero();   // N s, of all rows
  Vec2 momentum = Vec2::Zero();  // N s, what has come to be of the block
  double exchanged = 0;          // N s, of the sizes of forces
};

Readings readings_of(const Pendulum& pendulum, const Integrator& integrator, double dt, int steps,
                     const std::vector<double>& right) {
  Model model = model_of(pendulum);
  measure(model, Quantity::reaction).supports = {0};
  model.stages = {stage_of_turning(integrator, dt, steps * dt)};
  Simulation simulation = simulation_of(model);
  Readings readings;
  for (int step = 0; step < steps; ++step) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const std::vector<double> reaction = sampled(simulation);
    const Vec2 force(reaction[0], reaction[1]);
    readings.impulse += dt * force;
    readings.exchanged += dt * force.norm();
    // The block begins without strain, and rings for a while.
    if (step >= steps / 2)
      readings.off += std::abs(force.norm() - right[static_cast<std::size_t>(step)]) / (steps / 2.0);
  }
  readings.momentum = pendulum.mass() * (simulation.state().velocity[0].head<2>() + Vec2(0, gravity * steps * dt));
  return readings;
}

// Motion was right and forces were up to 23 times the largest there is, as the support is stiff; under the midpoint
// rule, which damps nothing, pendulums flew apart. The first force is that of a block without strain: two steps of it
// and 0.2 % for second order in dt are what impulses may be off by.
TEST(TurningForces, SwingingBlocksPullAsRigidOnesDo) {
  Random random(1);
  for (int i = 0; i < 12; ++i) {
    const Pendulum pendulum{between(0.5, 3, random), between(0.2, 0.6, random), between(0.4, 1.6, random)};
    const double dt = between(0.5e-3, 2e-3, random);
    const int steps = static_cast<int>(std::lround(1.5 / dt));
    const std::vector<double> right = pulls_of(pendulum, dt, steps);
    const double largest = *std::ranges::max_element(right);
    for (const Integrator& integrator : integrators_with_forces_of_the_start()) {
      const Readings readings = readings_of(pendulum, integrator, dt, steps, right);
      EXPECT_LT((readings.impulse - readings.momentum).norm(), 2 * largest * dt + 2e-3 * readings.exchanged)
          << integrator.name << " " << i;
      if (integrator.conserves_contact_energy) continue;  // rings for ever
      EXPECT_LT(readings.off, 0.01 * largest) << integrator.name << " " << i;
    }
  }
}

// --- Two bonded blocks that turn about the middle between them ---

struct Pair {
  double length, height, spin;  // m, m, rad/s

  [[nodiscard]] double force() const {
    return stiff_rock().density * length * height * spin * spin * length / 2;  // that holds either block, N
  }
};

Model model_of(const Pair& pair, const JointMaterial& joint) {
  Model model;
  model.materials = {stiff_rock()};
  model.materials[0].poisson = 0;
  model.joints = {joint};
  model.blocks = {rectangle("left", -pair.length, -pair.height / 2, pair.length, pair.height),
                  rectangle("right", 0, -pair.height / 2, pair.length, pair.height)};
  finish_model(model);
  for (Block& block : model.blocks) {
    const double middle = block.moments.centroid.x();
    block.initial_velocity = {0, pair.spin * middle};
    block.initial_spin = pair.spin;
  }
  Measurement& contact = measure(model, Quantity::contact_force);
  contact.blocks = {0};
  contact.others = {1};
  return model;
}

struct Held {
  double force = 0;              // N, the mean of the second half
  double largest = 0;            // N
  Vec2 impulse = Vec2::Zero();   // N s, of all rows
  Vec2 momentum = Vec2::Zero();  // N s, what has come to be of the left block
};

Held held_by(Model model, int steps) {
  const double dt = model.stages[0].dt;
  Simulation simulation = simulation_of(std::move(model));
  const auto momentum = [&] { return Vec2(simulation.model().mass_of(0) * simulation.state().velocity[0].head<2>()); };
  Held held;
  held.momentum = -momentum();
  for (int step = 0; step < steps; ++step) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const std::vector<double> row = sampled(simulation);
    const Vec2 force(row[0], row[1]);
    if (step >= steps / 2) held.force += force.norm() / (steps - steps / 2);
    held.largest = std::max(held.largest, force.norm());
    held.impulse += dt * force;
  }
  held.momentum += momentum();
  return held;
}

// The blocks begin without strain, so that what holds them rings at first, under the midpoint rule for ever: by the
// mean of a quarter of a second it is right to 2 %, and impulses are but for one row at the start and at the end. The
// force was up to 90 times too large in steps of several passages of waves.
TEST(TurningForces, JointsHoldWhatTurns) {
  Random random(2);
  for (int i = 0; i < 12; ++i) {
    const Pair pair{between(0.5, 2, random), between(0.5, 2, random), between(0.2, 4, random)};
    const double dt = between(0.5e-3, 4e-3, random);
    const int steps = static_cast<int>(std::lround(0.25 / dt));
    for (const Integrator& integrator : integrators_with_forces_of_the_start())
      for (const JointMaterial& joint : {bond(InterfaceLaw::consistent), strong(InterfaceLaw::projected)}) {
        const bool conserves = integrator.conserves_contact_energy;
        if (conserves && joint.law == InterfaceLaw::projected) continue;  // they do not go together
        Model model = model_of(pair, joint);
        model.stages = {stage_of_turning(integrator, dt, steps * dt)};
        const Held held = held_by(std::move(model), steps);
        const std::string which = integrator.name + " " + std::to_string(i);
        EXPECT_LT((held.impulse - held.momentum).norm(), 2 * held.largest * dt) << which;
        if (conserves) continue;
        EXPECT_NEAR(held.force / pair.force(), 1, 0.02) << which;
      }
  }
}

// --- A dry block on a base that tilts, less than friction lets slide ---

struct Tilt {
  double angle, duration;  // rad, s: the base begins and ends without a jerk, its acceleration being a sine
  double width, height;    // m, of the block, drawn in the middle of the base
  double pivot;            // m, to the right of that, on the base

  [[nodiscard]] double most_growth() const { return 2 * std::numbers::pi * angle / (duration * duration); }  // rad/s2
  // Shear over pressure between rigid ones at this share of the duration.
  [[nodiscard]] double friction_taken(double share) const {
    const double phase = 2 * std::numbers::pi * share;
    const double turn = angle * (phase - std::sin(phase)) / (2 * std::numbers::pi);
    const double rate = angle / duration * (1 - std::cos(phase)), growth = most_growth() * std::sin(phase);
    const double along = gravity * std::sin(turn) - growth * height / 2 + rate * rate * pivot;
    const double across = gravity * std::cos(turn) - growth * pivot - rate * rate * height / 2;
    return std::abs(along) / across;
  }
  [[nodiscard]] double most_friction_taken() const {
    double most = 0;
    for (int i = 0; i <= 1000; ++i) most = std::max(most, friction_taken(i / 1000.0));
    return most;
  }
};

Model model_of(const Tilt& tilt, double friction, const Stage& stage) {
  Model model;
  model.materials = {stiff_rock()};
  model.materials[0].young = 1e10;
  model.joints = {dry_projected(friction)};
  model.blocks = {rectangle("base", -4, -1, 8, 1), rectangle("block", -tilt.width / 2, 0, tilt.width, tilt.height)};
  model.gravity = {0, -gravity};
  HeldBlock base;
  base.kind = MotionKind::acceleration;
  base.turn = tilt.most_growth();
  base.about = {tilt.pivot, 0};
  base.history = SineCycles{1 / tilt.duration, 1, 0};
  model.held_blocks = {base};
  model.stages = {settling_stage(1e-9), stage};
  return model;
}

// Friction, which has a twentieth left, is judged by the forces of the joint: 18 of these 32 slid, by up to 75 mm.
TEST(TurningForces, BlocksStayOnABaseThatTilts) {
  Random random(3);
  for (int i = 0; i < 16; ++i) {
    const double width = between(0.6, 2, random);
    const Tilt tilt{between(0.3, 0.5, random), between(0.5, 1.5, random), width, between(0.3, 0.5, random) * width,
                    between(-0.5, 0.5, random)};
    const double dt = between(1e-3, 2e-3, random);
    for (const Integrator& integrator : {generalized_alpha_integrator(0.85), hht_integrator(0.1)}) {
      const Stage stage = stage_of_turning(integrator, dt, tilt.duration);
      Simulation simulation = simulation_of(model_of(tilt, tilt.most_friction_taken() / 0.95, stage));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      const Vec2 arm = simulation.model().blocks[1].moments.centroid - Vec2(tilt.pivot, 0);
      const Vec2 carried = rotation(simulation.state().displacement[0](2)) * arm - arm;
      const double slid = (simulation.state().displacement[1].head<2>() - carried).norm();
      EXPECT_LT(slid, 1e-5 * width) << integrator.name << " " << i;
    }
  }
}

}  // namespace
}  // namespace dda
