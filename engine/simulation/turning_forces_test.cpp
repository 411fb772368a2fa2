// Forces on blocks that turn, under every integrator: what rows say is what changes momentum, and what judges friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
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
constexpr double stiff = 5e10;    // Pa

std::vector<Integrator> integrators_with_forces_of_the_start() {
  return {generalized_alpha_integrator(0.85), generalized_alpha_integrator(0.5), hht_integrator(0.1),
          hht_integrator(0.3), energy_conserving_integrator()};
}

Stage stage_of_turning(const Integrator& integrator, double dt, double duration) {
  return stage_of(integrator, dt, static_cast<int>(std::lround(duration / dt)), Kinematics::finite);
}

// Runs a stage whose first measurement is a force; returns that force after every step, N.
std::vector<Vec2> forces_of(Simulation& simulation) {
  std::vector<Vec2> forces;
  while (!simulation.finished() && simulation.step() == Status::ok) {
    const std::vector<double> row = sampled(simulation);
    forces.emplace_back(row[0], row[1]);
  }
  EXPECT_TRUE(simulation.finished()) << simulation.message();
  return forces;
}

std::vector<double> sizes_of(const std::vector<Vec2>& forces) {
  std::vector<double> sizes;
  for (const Vec2& force : forces) sizes.push_back(force.norm());
  return sizes;
}

// Blocks begin without strain, and ring for a while.
double mean_of_second_half(const std::vector<double>& values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  return std::accumulate(half, values.end(), 0.0) / static_cast<double>(values.end() - half);
}

Vec2 sum_of(const std::vector<Vec2>& forces) { return std::accumulate(forces.begin(), forces.end(), Vec2(0, 0)); }

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
  model.materials = {rock_of(stiff)};
  model.gravity = {0, -gravity};
  const Vec2 along(std::sin(pendulum.start), -std::cos(pendulum.start));
  const Vec2 across = pendulum.height / 2 * Vec2(-along.y(), along.x());
  const Vec2 end = pendulum.length * along;
  Block& block = model.blocks.emplace_back();
  block.name = "pendulum";
  block.shape.outer = {-across, end - across, end + across, across};
  model.supports = {{0, {0, 0}, true, true, 1000 * stiff, Vec2::Zero(), {}}};
  return model;
}

Simulation simulation_of(const Pendulum& pendulum, const Stage& stage) {
  Model model = model_of(pendulum);
  measure(model, Quantity::reaction).supports = {0};
  model.stages = {stage};
  return simulation_of(std::move(model));
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
      Simulation simulation = simulation_of(pendulum, stage_of_turning(integrator, dt, steps * dt));
      const std::vector<Vec2> forces = forces_of(simulation);
      ASSERT_EQ(forces.size(), right.size());
      std::vector<double> sizes = sizes_of(forces);
      const double exchanged = dt * std::accumulate(sizes.begin(), sizes.end(), 0.0);
      const Vec2 falling(0, -gravity * steps * dt);
      const Vec2 momentum = pendulum.mass() * (simulation.state().velocity[0].head<2>() - falling);
      EXPECT_LT((dt * sum_of(forces) - momentum).norm(), 2 * largest * dt + 2e-3 * exchanged)
          << integrator.name << " " << i;
      if (integrator.conserves_contact_energy) continue;  // rings for ever
      for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::abs(sizes[k] - right[k]);
      EXPECT_LT(mean_of_second_half(sizes), 0.01 * largest) << integrator.name << " " << i;
    }
  }
}

// --- Two bonded blocks that turn about the middle between them ---

struct Pair {
  double length, height, spin;  // m, m, rad/s

  [[nodiscard]] double force() const {
    return rock().density * length * height * spin * spin * length / 2;  // that holds either block, N
  }
};

Model model_of(const Pair& pair, const JointMaterial& joint) {
  Model model;
  model.materials = {rock_of(stiff)};
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
        Simulation simulation = simulation_of(std::move(model));
        const Vec2 at_first = simulation.state().velocity[0].head<2>();
        const std::vector<Vec2> forces = forces_of(simulation);
        const Vec2 momentum = simulation.model().mass_of(0) * (simulation.state().velocity[0].head<2>() - at_first);
        const std::vector<double> sizes = sizes_of(forces);
        const double largest = *std::ranges::max_element(sizes);
        const std::string which = integrator.name + " " + std::to_string(i);
        EXPECT_LT((dt * sum_of(forces) - momentum).norm(), 2 * largest * dt) << which;
        if (conserves) continue;
        EXPECT_NEAR(mean_of_second_half(sizes) / pair.force(), 1, 0.02) << which;
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
  model.materials = {rock_of(1e10)};
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
