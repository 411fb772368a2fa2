#include "verification/cases/collision_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/cases/contact_rig.h"
#include "verification/exact/block_row.h"
#include "verification/exact/collision.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double young = 5e9;
constexpr double density = 2600;
constexpr double speed = 0.01;  // m/s: strains below 1e-6, so that linear equations hold

// Cubes of 1 m in a row, nothing else; the first runs into the others.
exact::BlockRow row_of(int blocks, double gap, double spring_over_young) {
  exact::BlockRow row;
  row.mass = density;
  row.length = 1;
  row.axial_stiffness = young;
  row.spring = 2 * spring_over_young * young;
  row.gaps.assign(static_cast<std::size_t>(blocks - 1), gap);
  row.velocity.assign(static_cast<std::size_t>(blocks), 0.0);
  row.velocity[0] = speed;
  return row;
}

double contact_time(const exact::BlockRow& row) { return std::numbers::pi * std::sqrt(row.mass / (2 * row.spring)); }

// Long enough for every impact along the row.
double duration(const exact::BlockRow& row) {
  const auto impacts = static_cast<double>(row.gaps.size());
  return impacts * (row.gaps[0] / speed + 2.5 * contact_time(row));
}

dda::Model model_of(const exact::BlockRow& row) {
  dda::Model model;
  model.materials = {{"rock", density, young, 0, dda::PlaneState::stress}};
  model.joints = {dry_joint(0)};
  model.joints[0].spring_over_young = row.spring / (2 * young);
  for (std::size_t i = 0; i < row.velocity.size(); ++i) {
    const double left = static_cast<double>(i) * (row.length + row.gaps[0]);
    const int block = add_box(model, left, 0, left + row.length, 1);
    model.blocks[static_cast<std::size_t>(block)].initial_velocity = {row.velocity[i], 0};
  }
  return model;
}

std::vector<double> velocities(const dda::State& state) {
  std::vector<double> all;
  for (const dda::Vec6& velocity : state.velocity) all.push_back(velocity(0));
  return all;
}

struct Passed {
  std::vector<double> velocity;  // m/s, at the end
  double error = 0;              // of the velocities, largest, over the speed
  double momentum = 0;           // relative change
  double lost = 0;               // numerical dissipation over the energy of the first block
  double residual = 0;
};

Passed pass_on(const exact::BlockRow& row, int steps, const exact::BlockRowState& expected, Outcome& outcome) {
  dda::Model model = model_of(row);
  const double end = duration(row);
  model.stages = {moving_stage(dda::energy_conserving_integrator(), end / steps, end)};
  WatchedRun run(std::move(model));
  run.run_to_end();
  Passed passed{velocities(run.state())};
  double momentum = 0;
  for (std::size_t i = 0; i < passed.velocity.size(); ++i) {
    passed.error = std::max(passed.error, std::abs(passed.velocity[i] - expected.velocity[i]) / speed);
    momentum += passed.velocity[i];
  }
  passed.momentum = momentum / speed - 1;
  passed.lost = run.simulation().energy().numerical / run.simulation().energy().initial.kinetic;
  passed.residual = run.energy_residual();
  outcome.counters += run.simulation().counters();
  return passed;
}

// What every row of blocks must keep.
void judge_balance(const Passed& passed, int steps, const std::string& name, Outcome& outcome) {
  outcome.assertions.push_back(expect("change of momentum, " + name, "-")
                                   .is(passed.momentum)
                                   .against(0, "none (error absolute)")
                                   .absolutely()
                                   .within(steps * 1e-15, "round-off of a solve a step"));
  outcome.assertions.push_back(
      expect("numerical dissipation over the energy brought in, " + name, "-")
          .is(passed.lost)
          .against(0, "none: contact forces of the scheme work as their springs (error absolute)")
          .absolutely()
          .within(1e-6, "gaps are measured anew in the geometry reached, which moves by the strains, 2e-7"));
  outcome.assertions.push_back(energy_assertion(name, passed.residual));
}

// Contacts a thousand times softer than blocks, so that an impact lasts long against the blocks' own vibration and
// leaves little of it; gaps so wide that one impact has ended before the next begins.
Outcome cradle() {
  constexpr int steps = 4000;
  constexpr double softness = 1e-3;
  const exact::BlockRow row = row_of(5, 1e-3, softness);
  Outcome outcome;
  const Passed passed = pass_on(row, steps, exact::move_block_row(row, duration(row)), outcome);
  const double ratio = softness / 3;
  for (std::size_t i = 0; i < passed.velocity.size(); ++i) {
    const double expected = i + 1 == passed.velocity.size() ? 1 : 0;
    outcome.assertions.push_back(
        expect(fmt::format("velocity of block {} over that of the blow", i + 1), "-")
            .is(passed.velocity[i] / speed)
            .against(expected, "equal bodies exchange their velocities (error absolute)")
            .absolutely()
            .within(4 * 10 * ratio * ratio,
                    "theory: a blow leaves the square of its frequency over the block's, squared again, "
                    "as vibration, (k/3 E)^2 = 1e-7; four blows, ten times"));
  }
  judge_balance(passed, steps, "row with gaps", outcome);
  return outcome;
}

// Blocks that touch from the start do not pass on all: springs all along the row are compressed at once.
Outcome touching_row() {
  constexpr int steps = 4000;
  const exact::BlockRow row = row_of(5, 0, 1e-3);
  const exact::BlockRowState expected = exact::move_block_row(row, duration(row));
  Outcome outcome;
  const auto error = [&](int n) { return pass_on(row, n, expected, outcome).error; };
  const Passed passed = pass_on(row, steps, expected, outcome);
  const Order order{std::log2(error(steps / 2) / passed.error), 2, 0.05};
  for (std::size_t i = 0; i < passed.velocity.size(); ++i)
    outcome.assertions.push_back(
        expect(fmt::format("velocity of block {} over that of the blow", i + 1), "-")
            .is(passed.velocity[i] / speed)
            .against(expected.velocity[i] / speed,
                     "Runge-Kutta integration of centroids and strains (exact/block_row; error absolute)")
            .off_by((passed.velocity[i] - expected.velocity[i]) / speed)
            .within(1e-5, "second order in dt, measured 7.4e-6 at 380 steps to an impact"));
  outcome.assertions.push_back(expect("largest error of a velocity over that of the blow", "-")
                                   .is(passed.error)
                                   .against(0, "exact/block_row (error absolute)")
                                   .absolutely()
                                   .of_order(order)
                                   .within(1e-5, "as above"));
  judge_balance(passed, steps, "touching row", outcome);
  return outcome;
}

// ---- Collisions after which bodies go on together.

constexpr double light = density;      // kg, a cube of 1 m
constexpr double heavy = 3 * density;  // kg, three times as high

// A cube runs into a block three times its height, at half of it; dashpots beside the contact springs.
dda::Model damped_collision(double softness, double damping) {
  dda::Model model;
  model.materials = {{"rock", density, young, 0, dda::PlaneState::stress}};
  model.joints = {dry_joint(0)};
  model.joints[0].spring_over_young = softness;
  model.joints[0].contact_damping = damping;
  add_box(model, 0, 0, 1, 1);
  add_box(model, 1.001, -1, 2.001, 2);
  model.blocks[0].initial_velocity = {speed, 0};
  return model;
}

struct Collided {
  double velocity[2] = {0, 0};  // m/s
  double lost = 0;              // J, of kinetic energy
  double residual = 0;
};

Collided collide(dda::Model model, const dda::Integrator& integrator, double dt, double end, Outcome& outcome) {
  model.stages = {moving_stage(integrator, dt, end)};
  WatchedRun run(std::move(model));
  run.run_to_end();
  const std::vector<double> all = velocities(run.state());
  const dda::EnergyLedger& energy = run.simulation().energy();
  outcome.counters += run.simulation().counters();
  return {{all[all.size() - 2], all.back()}, energy.initial.kinetic - energy.kinetic, run.energy_residual()};
}

void judge_momentum(const Collided& collided, double m1, double v1, double m2, double tolerance,
                    const std::string& reason, const std::string& name, Outcome& outcome) {
  const double momentum = (m1 * collided.velocity[0] + m2 * collided.velocity[1]) / (m1 * v1) - 1;
  outcome.assertions.push_back(expect("change of momentum, " + name, "-")
                                   .is(momentum)
                                   .against(0, "none (error absolute)")
                                   .absolutely()
                                   .within(tolerance, reason));
}

Outcome dashpot_collision() {
  constexpr double softness = 1e-6;  // contact springs over Young's modulus
  constexpr double dt = 2.5e-4;
  constexpr double spring = softness * young;
  const double common = exact::common_velocity(light, speed, heavy, 0);
  Outcome outcome;
  for (const double damping : {0.1, 1.0, 10.0}) {
    const std::string name = fmt::format("contact damping {}", damping);
    const double dashpot = 2 * 2 * damping * std::sqrt(spring * light);  // two contacts
    const double expected = exact::dashpot_restitution(2 * spring, dashpot, exact::reduced_mass(light, heavy));
    const Collided collided =
        collide(damped_collision(softness, damping), dda::energy_conserving_integrator(), dt, 2, outcome);
    const double restitution = (collided.velocity[1] - collided.velocity[0]) / speed;
    outcome.assertions.push_back(
        expect("restitution, " + name, "-")
            .is(restitution)
            .against(expected, "spring and dashpot that do not pull (exact/collision; error absolute)")
            .absolutely()
            .within(2 * softness, "theory: blocks yield by the stiffness of the contacts over theirs"));
    judge_momentum(collided, light, speed, heavy, 2 / dt * 1e-15, "round-off of a solve a step", name, outcome);
    outcome.assertions.push_back(energy_assertion(name, collided.residual));
    if (damping < 10) continue;
    // Too stiff a dashpot to throw anything back: what remains of the approach is below a thousandth.
    for (int i = 0; i < 2; ++i)
      outcome.assertions.push_back(
          expect(fmt::format("velocity of block {}, {}", i + 1, name), "m/s")
              .is(collided.velocity[i])
              .against(common, "m1 v1/(m1 + m2)")
              .within((expected + 2 * softness) * (i == 0 ? heavy / light : 1),
                      "theory: the restitution of the dashpot times the share of the other mass"));
  }
  return outcome;
}

// Two blocks, pressed from above and below on a cart that nothing holds, slide until all three go on together: friction
// makes the impact inelastic. Pressed from both sides, the cart stays level; with a load for weight, nothing can take
// up momentum along it.
Outcome pressed_cart() {
  constexpr double friction = 0.5;
  constexpr double velocity = 2;
  constexpr double height = 0.5;
  constexpr double pressure = 1e4;
  constexpr double blocks = 2 * density * height;
  constexpr double wagon = 4 * density * height;
  dda::Model model;
  model.materials = {{"rock", density, 50e9, 0.2, dda::PlaneState::stress}};
  model.joints = {dry_joint(std::atan(friction))};
  add_box(model, 0.5, -height, 1.5, 0);
  add_box(model, 0.5, height, 1.5, 2 * height);
  add_box(model, 0, 0, 4, height);
  model.edge_loads = {{0, {0.5, -height}, {1.5, -height}, {0, pressure}, {}},
                      {1, {1.5, 2 * height}, {0.5, 2 * height}, {0, -pressure}, {}}};
  model.blocks[0].initial_velocity = model.blocks[1].initial_velocity = {velocity, 0};
  Outcome outcome;
  const Collided collided = collide(std::move(model), dda::generalized_alpha_integrator(0), 1e-3, 1, outcome);
  const double common = exact::common_velocity(blocks, velocity, wagon, 0);
  constexpr double round_off = 1e-10;
  const std::string round_off_reason =
      "round-off of 7e-14 a step: contact springs (8e11 N/m) times motion (2 mm) times dt over the momentum";
  const double lost = exact::reduced_mass(blocks, wagon) * velocity * velocity / 2;
  for (int i = 0; i < 2; ++i)
    outcome.assertions.push_back(
        expect(i == 0 ? "velocity of the blocks at the end" : "velocity of the cart at the end", "m/s")
            .is(collided.velocity[i])
            .against(common, "m1 v1/(m1 + m2)")
            .within(round_off, round_off_reason));
  outcome.assertions.push_back(expect("kinetic energy lost", "J")
                                   .is(collided.lost)
                                   .against(lost, "m1 m2/(m1 + m2) v1^2/2")
                                   .within(2 * round_off, round_off_reason));
  judge_momentum(collided, blocks, velocity, wagon, round_off, round_off_reason, "blocks on a cart", outcome);
  outcome.assertions.push_back(energy_assertion("blocks on a cart", collided.residual));
  return outcome;
}

}  // namespace

std::vector<Case> collision_cases() {
  return {{"newtons-cradle", "Row of five blocks, one strikes", {6}, CaseLabel::fast, cradle},
          {"touching-row", "Row of five blocks that touch, one strikes", {6}, CaseLabel::fast, touching_row},
          {"dashpot-collision", "Collision damped by the contact", {7}, CaseLabel::fast, dashpot_collision},
          {"pressed-cart", "Cart that carries off two blocks by friction", {7}, CaseLabel::fast, pressed_cart}};
}

}  // namespace verify
