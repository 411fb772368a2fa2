#include "verification/cases/projected_joint_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "engine/simulation/simulation.h"
#include "verification/cases/opening_mesh.h"
#include "verification/exact/no_tension_column.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/lattice/bloch.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::InterfaceLaw;
using dda::Vec2;
using dda::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double density = 2650;
constexpr double young = 50e9;

dda::Material rock_of(double poisson) { return {"rock", density, young, poisson, dda::PlaneState::stress}; }

dda::JointMaterial joint_of(InterfaceLaw law, bool bonded) {
  dda::JointMaterial joint;
  joint.law = law;
  joint.bonded = bonded;
  joint.friction_angle = 35 * pi / 180;
  joint.shear_to_normal = 1;  // of classical springs
  return joint;
}

dda::Stage stage_of(const dda::Integrator& integrator, double dt, int steps) {
  dda::Stage stage;
  stage.integrator = integrator;
  stage.kinematics = dda::Kinematics::small;
  stage.dt = dt;
  stage.duration = dt * steps;
  stage.solver = dda::SolverRequest::cholesky;
  return stage;
}

dda::Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

// ---- Waves far below slip: joints stick, and the matrices are those of the joints as they are.

struct SpeedErrors {
  double s = 0, p = 0;
};

SpeedErrors speed_errors(const PeriodicMesh& mesh, const dda::JointMaterial& joint, double degrees, double blocks) {
  constexpr double poisson = 1.0 / 3;
  const double angle = degrees * pi / 180;
  const Vec2 q = 2 * pi / (blocks * mesh.longest_side()) * Vec2(std::cos(angle), std::sin(angle));
  const PhaseSpeeds speeds = phase_speeds(mesh, rock_of(poisson), joint, q);
  return {relative_error(speeds.s, exact::s_speed(young, poisson, density)),
          relative_error(speeds.p, exact::p_speed_plane_stress(young, poisson, density))};
}

void assert_speeds(const std::string& name, const PeriodicMesh& mesh, double degrees, double tolerance,
                   Outcome& outcome) {
  const dda::JointMaterial joint = joint_of(InterfaceLaw::projected, true);  // the matrix of dry joints that stick
  const SpeedErrors errors = speed_errors(mesh, joint, degrees, 20);
  for (const auto& [wave, error] : {std::pair("P", errors.p), std::pair("S", errors.s)})
    outcome.assertions.push_back(
        expect(fmt::format("error of the {} speed at {} degrees, {}, 20 blocks a wavelength (error "
                           "absolute)",
                           wave, degrees, name),
               "-")
            .is(error)
            .against(0, "isotropic continuum, plane stress, nu = 1/3")
            .absolutely()
            .within(tolerance, tolerance == 5e-3 ? "promised" : "measured with margin"));
}

Outcome wave_speeds() {
  Outcome outcome;
  for (const double degrees : {0.0, 22.5, 45.0}) {
    assert_speeds("squares", square_mesh(), degrees, 5e-3, outcome);
    assert_speeds("bricks in running bond", brick_mesh(), degrees, 6e-3, outcome);
    assert_speeds("triangles", triangle_mesh(), degrees, 5e-3, outcome);
  }
  return outcome;
}

// Springs of 10 E as the thesis has them, for the same waves: what the table of the projected law is held against.
Outcome wave_speeds_of_springs() {
  Outcome outcome;
  struct Published {
    double degrees, p, s;
  };
  for (const Published& of : {Published{0, -0.026, -0.014}, {22.5, 0.021, 0.13}, {45, 0.066, 0.26}}) {
    const SpeedErrors errors = speed_errors(square_mesh(), joint_of(InterfaceLaw::classical, false), of.degrees, 20);
    const auto add = [&](const char* wave, double error, double published) {
      outcome.assertions.push_back(
          expect(fmt::format("error of the {} speed at {} degrees, squares, springs of 10 E (error "
                             "absolute)",
                             wave, of.degrees),
                 "-")
              .is(error)
              .against(published, "an independent prototype, two digits")
              .absolutely()
              .within(6e-3, "half of the last digit, and a bit"));
    };
    add("P", errors.p, of.p);
    add("S", errors.s, of.s);
  }
  return outcome;
}

// ---- Uniform stress through bricks of random lengths, whose joints are shifted against each other.

dda::Model random_bricks(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(0.4, 1.6);
  constexpr double width = 6;
  dda::Model model;
  model.materials = {rock_of(0.25)};
  model.joints = {joint_of(InterfaceLaw::projected, false)};
  double bottom = 0;
  for (int row = 0; row < 6; ++row) {
    const double top = bottom + between(random);
    double left = 0;
    while (left < width) {
      double right = left + between(random);
      if (width - right < 0.3) right = width;
      model.blocks.emplace_back().shape.outer = box(left, bottom, right, top);
      left = right;
    }
    bottom = top;
  }
  return model;
}

Outcome patch() {
  Outcome outcome;
  const Vec3 stress(-8e6, -5e6, 1.5e6);
  double largest = 0;
  for (const unsigned seed : {1U, 2U, 3U}) {
    dda::Model model = random_bricks(seed);
    model.stages = {stage_of(dda::static_integrator(), 10, 20)};
    dda::finish_model(model);
    hold_outside(model, stress);
    dda::finish_model(model);
    dda::Simulation simulation(model);
    advance_to_end(simulation);
    outcome.counters += simulation.counters();
    for (const Vec3& each : simulation.state().stress) keep_largest(largest, (each - stress).norm() / stress.norm());
  }
  outcome.assertions.push_back(
      expect("stress of random dry bricks, largest difference over the stress (error absolute)", "-")
          .is(largest)
          .against(0, "the traction on the outline")
          .absolutely()
          .within(1e-10, "a solve of condition 1e4 and what statics leave out of balance"));
  return outcome;
}

// ---- A column under an eccentric load.

constexpr int column_blocks = 6;
constexpr double load = 1e5;  // N per m of thickness

dda::Model column(InterfaceLaw law, double eccentricity) {
  dda::Model model;
  model.materials = {rock_of(0.25)};
  model.joints = {joint_of(law, false)};
  model.blocks.emplace_back().shape.outer = box(-2, -1, 2, 0);
  for (int i = 0; i < column_blocks; ++i) model.blocks.emplace_back().shape.outer = box(-0.5, i, 0.5, i + 1);
  model.held_blocks.emplace_back().block = 0;
  model.point_loads = {{column_blocks, {eccentricity, column_blocks}, {0, -load}, {}}};
  model.stages = {stage_of(dda::static_integrator(), 10, 60)};
  dda::finish_model(model);
  return model;
}

// Turn of the uppermost block's centroid.
double turn_of(InterfaceLaw law, double eccentricity, Outcome& outcome,
               dda::Kinematics kinematics = dda::Kinematics::small) {
  dda::Model model = column(law, eccentricity);
  model.stages[0].kinematics = kinematics;
  dda::finish_model(model);
  dda::Simulation simulation(std::move(model));
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  return -simulation.state().displacement.back()(2);
}

Outcome eccentric_column() {
  Outcome outcome;
  for (const double e : {0.05, 0.1, 0.16, 0.2, 0.3, 0.4}) {
    const double expected = exact::no_tension_turn(load, e, 1, column_blocks - 0.5, young);
    const double turn = turn_of(InterfaceLaw::projected, e, outcome);
    outcome.assertions.push_back(
        expect(fmt::format("turn of a column of 6 dry blocks, load at {} of its width", e), "rad")
            .is(turn)
            .against(expected, "column without tension")
            .within(1e-8, "measured with margin: steps balance to 1e-10 of a force"));
  }
  for (const double e : {0.1, 0.3}) {
    const double turn = turn_of(InterfaceLaw::projected, e, outcome, dda::Kinematics::finite);
    outcome.assertions.push_back(
        expect(fmt::format("the same in finite kinematics, load at {} of its width", e), "rad")
            .is(turn)
            .against(exact::no_tension_turn(load, e, 1, column_blocks - 0.5, young), "column without tension")
            .within(2.5e-3,
                    "the load moves sideways by 2e-4 of the width, and the turn grows by up to ten times as much"));
  }
  // Corner springs turn a hundred times too little: what the law is for.
  const double springs = turn_of(InterfaceLaw::classical, 0.1, outcome);
  const double expected = exact::no_tension_turn(load, 0.1, 1, column_blocks - 0.5, young);
  outcome.assertions.push_back(expect("the same at 0.1 with springs of 10 E, over the exact turn (error absolute)", "-")
                                   .is(springs / expected)
                                   .against(0, "locked")
                                   .absolutely()
                                   .within(0.05, "measured with margin"));
  return outcome;
}

// Whether an end of the lowest joint gapes.
bool gapes(double eccentricity, Outcome& outcome) {
  dda::Simulation simulation(column(InterfaceLaw::projected, eccentricity));
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  return std::ranges::any_of(simulation.contacts().states[0].status,
                             [](dda::ContactStatus status) { return status == dda::ContactStatus::open; });
}

Outcome kern() {
  Outcome outcome;
  double closed = 0.1;
  double open = 0.3;
  while (open - closed > 1e-7) {
    const double middle = (open + closed) / 2;
    (gapes(middle, outcome) ? open : closed) = middle;
  }
  outcome.assertions.push_back(expect("eccentricity at which a dry joint begins to gape, over its width", "-")
                                   .is(closed)
                                   .against(1.0 / 6, "core of a rectangular section")
                                   .within(2e-6, "bisected to 1e-7"));
  return outcome;
}

// ---- A block that a growing force pushes along its foot.

Outcome slip() {
  constexpr double weight = density * 9.81;
  constexpr int steps = 4000;
  Outcome outcome;
  dda::Model model;
  model.materials = {rock_of(0.25)};
  model.joints = {joint_of(InterfaceLaw::projected, false)};
  model.blocks.emplace_back().shape.outer = box(-2, -1, 2, 0);
  model.blocks.emplace_back().shape.outer = box(-0.5, 0, 0.5, 1);
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  const double capacity = std::tan(model.joints[0].friction_angle) * weight;
  const dda::PiecewiseLinear ramp{{0, steps * 0.01}, {0, 2}};
  model.point_loads = {{1, {-0.5, 0}, {capacity, 0}, ramp}};
  model.stages = {stage_of(dda::static_integrator(), 0.01, steps)};
  dda::finish_model(model);
  dda::Simulation simulation(model);
  int step = 0;
  const auto slides = [&] { return simulation.contacts().states[0].status[0] == dda::ContactStatus::sliding; };
  while (!slides() && step < steps) {
    advance(simulation, 1);
    ++step;
  }
  outcome.counters += simulation.counters();
  const double share = 2.0 * (step - 0.5) / steps;
  outcome.assertions.push_back(
      expect("force at which a block slides on its foot, over tan(friction) times its weight", "-")
          .is(share)
          .against(1, "Coulomb")
          .absolutely()
          .within(1.01 / steps, "half a step of the load"));
  return outcome;
}

// ---- A pulse at a point in squares under pressure, far below slip.

constexpr double pressure = 10e6;
constexpr double pulse_length = 12e-3;  // s: S waves of 33 blocks

// sin^2, one hump.
dda::PiecewiseLinear hump() {
  dda::PiecewiseLinear table;
  for (int i = 0; i <= 120; ++i) {
    table.times.push_back(pulse_length * i / 120);
    table.values.push_back(std::pow(std::sin(pi * i / 120), 2));
  }
  return table;
}

dda::Model pressed_squares(int size, const dda::JointMaterial& joint) {
  dda::Model model;
  model.materials = {rock_of(0.25)};
  model.joints = {joint};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      dda::Block block;
      block.shape.outer = box(column, row, column + 1, row + 1);
      block.initial_stress = {-pressure, -pressure, 0};
      model.blocks.push_back(block);
    }
  const int half = size / 2;
  const double middle = half + 0.5;
  const int source = half * size + half;
  model.point_loads = {{source, {middle, middle}, {1e5, 0.5e5}, hump()}};
  for (const Vec2& away : {Vec2(8, 0), Vec2(0, 8), Vec2(6, 6), Vec2(-7, 3)})
    for (const dda::Quantity quantity : {dda::Quantity::velocity_x, dda::Quantity::velocity_y}) {
      dda::Measurement measurement;
      measurement.quantity = quantity;
      measurement.point = Vec2(middle, middle) + away;
      measurement.block = source + static_cast<int>(away.y()) * size + static_cast<int>(away.x());
      measurement.name = fmt::format("{}", model.measurements.size());
      model.measurements.push_back(measurement);
    }
  model.stages = {stage_of(dda::generalized_alpha_integrator(0.8), 1e-4, 160)};
  model.stages[0].correct_block_dispersion = true;  // acts where all is bonded
  dda::finish_model(model);
  hold_outside(model, {-pressure, -pressure, 0});
  dda::finish_model(model);
  return model;
}

double distance(const RecordedRun& run, const RecordedRun& reference) {
  double difference = 0;
  double size = 0;
  for (std::size_t i = 0; i < run.histories.size(); ++i)
    for (std::size_t k = 0; k < run.histories[i].size(); ++k) {
      difference += std::pow(run.histories[i][k] - reference.histories[i][k], 2);
      size += std::pow(reference.histories[i][k], 2);
    }
  return std::sqrt(difference / size);
}

Outcome point_pulse() {
  constexpr int size = 30;
  Outcome outcome;
  const RecordedRun bonded = record_run(pressed_squares(size, joint_of(InterfaceLaw::consistent, true)));
  outcome.counters += bonded.counters;
  const auto add = [&](const char* name, dda::Kinematics kinematics) {
    dda::Model model = pressed_squares(size, joint_of(InterfaceLaw::projected, false));
    model.stages[0].kinematics = kinematics;
    dda::finish_model(model);
    const RecordedRun dry = record_run(model);
    outcome.counters += dry.counters;
    const double away = distance(dry, bonded);
    outcome.assertions.push_back(
        expect(fmt::format("velocities in dry squares under pressure, {}, off those in bonded ones, "
                           "L2 (error absolute)",
                           name),
               "-")
            .is(away)
            .against(0, "the same blocks, bonded")
            .absolutely()
            .within(1e-2, "promised"));
  };
  add("projected law", dda::Kinematics::small);
  add("projected law in finite kinematics", dda::Kinematics::finite);
  return outcome;
}

}  // namespace

std::vector<Case> projected_joint_cases() {
  return {{"projected-wave-speeds",
           "Plane waves through dry joints that stick, projected law",
           {42},
           CaseLabel::fast,
           wave_speeds},
          {"projected-springs", "The same through springs of 10 E", {42}, CaseLabel::fast, wave_speeds_of_springs},
          {"projected-patch", "Uniform stress through dry bricks of random sizes", {24}, CaseLabel::fast, patch},
          {"projected-column", "Column of dry blocks under an eccentric load", {16}, CaseLabel::fast, eccentric_column},
          {"projected-kern", "Where a dry joint begins to gape", {16}, CaseLabel::fast, kern},
          {"projected-pulse",
           "Pulse at a point in dry squares under pressure, against bonded ones",
           {42},
           CaseLabel::fast,
           point_pulse},
          {"projected-slip", "Moment of slip under the projected law", {9}, CaseLabel::fast, slip}};
}

}  // namespace verify
