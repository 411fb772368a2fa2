#include "verification/cases/sliding_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "verification/cases/contact_rig.h"
#include "verification/cases/every_integrator.h"
#include "verification/exact/coulomb_sliding.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double slope = 30 * degree;
const dda::Material rock{"rock", 2600, 5e9, 0.2, dda::PlaneState::stress};

// A cube of 1 m on a base; the plane is level and gravity turned.
dda::Model block_on_incline(double friction_angle) {
  dda::Model model;
  model.materials = {rock};
  model.joints = {dry_joint(friction_angle)};
  hold_corners(model, add_box(model, -5, -1, 35, 0));
  add_box(model, 0, 0, 1, 1);
  model.gravity = standard_gravity * dda::Vec2(std::sin(slope), -std::cos(slope));
  return model;
}

WatchedRun settled_on_incline(double friction_angle, double dt, double duration,
                              const dda::Integrator& integrator = dda::thesis_integrator()) {
  dda::Model model = block_on_incline(friction_angle);
  model.stages = {settling_stage(), moving_stage(integrator, dt, duration)};
  WatchedRun run(std::move(model));
  run.run_to(settling_time);
  return run;
}

Outcome slide_down() {
  constexpr double duration = 2;
  Outcome outcome;
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    double residual = 0;
    double settling = 0;
    for (const double friction : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0}) {
      WatchedRun run = settled_on_incline(friction * degree, dt, duration);
      const double start = run.state().displacement[1](0);
      settling = std::max(settling, std::abs(start));
      run.run_to_end();
      const double slip = run.state().displacement[1](0) - start;
      const auto [drive, limit] = exact::incline_forces(standard_gravity, slope, friction * degree);
      const double expected = exact::CoulombSlider(drive, limit, 0, duration).position(duration);
      outcome.assertions.push_back(
          expect(fmt::format("slip in {} s, friction {} deg, dt = {} s", duration, friction, dt), "m")
              .is(slip)
              .against(expected, "g (sin a - cos a tan f) t^2/2")
              .within(1e-5,
                      "target of the project; theory: Eq. 5 is exact under a constant force, and elastic blocks move "
                      "by some "
                      "rho g h^2/E = 5e-6 m"));
      residual = std::max(residual, run.energy_residual());
      outcome.counters += run.simulation().counters();
    }
    outcome.assertions.push_back(
        expect(fmt::format("largest motion while gravity comes on, dt = {} s", dt), "m")
            .is(settling)
            .against(0, "no sliding in a stage of unlimited strength (error absolute)")
            .absolutely()
            .within(1e-5, "theory: a few times rho g h^2/E = 5e-6 m; sliding would be a hundred times that"));
    outcome.assertions.push_back(energy_assertion(fmt::format("worst friction, dt = {} s", dt), residual));
  }
  return outcome;
}

Outcome stay() {
  Outcome outcome;
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    WatchedRun run = settled_on_incline(35 * degree, dt, 8);
    run.run_to(settling_time + 1);
    const double after_one_second = run.state().displacement[1](0);
    double creep = 0;
    while (!run.simulation().finished()) {
      run.step();
      creep = std::max(creep, std::abs(run.state().displacement[1](0) - after_one_second));
    }
    outcome.assertions.push_back(expect(fmt::format("creep from 1 s to 8 s, friction 35 deg, dt = {} s", dt), "m")
                                     .is(creep)
                                     .against(0, "friction above the slope holds (error absolute)")
                                     .absolutely()
                                     .within(1e-9, "target of the project; theory: none"));
    outcome.assertions.push_back(energy_assertion(fmt::format("dt = {} s", dt), run.energy_residual()));
    outcome.counters += run.simulation().counters();
  }
  return outcome;
}

// Mean position (m) along the slope over the next second: what is left of vibrations cancels out.
double mean_position(WatchedRun& run) {
  const double end = run.state().time + 1;
  double sum = 0;
  int steps = 0;
  for (; run.state().time < end && !run.simulation().finished(); ++steps) {
    run.step();
    sum += run.state().displacement[1](0);
  }
  return sum / steps;
}

Outcome stay_under_every_integrator() {
  constexpr double duration = 20;
  Outcome outcome;
  double residual = 0;
  for (const double dt : {0.1, 0.01}) {
    for (const dda::Integrator& integrator : every_integrator()) {
      WatchedRun run = settled_on_incline(35 * degree, dt, duration, integrator);
      run.run_to(settling_time + 5);  // what friction and integrators take of vibrations is gone
      const double at_first = mean_position(run);
      run.run_to(settling_time + duration - 1);
      const double creep = std::abs(mean_position(run) - at_first);
      outcome.assertions.push_back(
          expect(fmt::format("creep from 5 s to {} s, dt = {} s, {}", duration, dt, integrator.name), "m")
              .is(creep)
              .against(0, "friction above the slope holds (error absolute)")
              .absolutely()
              .within(1e-9, "target of the project; theory: none"));
      residual = std::max(residual, run.energy_residual());
      outcome.counters += run.simulation().counters();
    }
  }
  outcome.assertions.push_back(energy_assertion("all integrators", residual));
  return outcome;
}

// The block runs from the start; its weight rings in the meantime, which friction evens out.
Outcome slide_to_rest() {
  constexpr double friction = 0.5;
  constexpr double velocity = 3;
  constexpr double height = 0.5;
  Outcome outcome;
  for (const dda::Integrator& integrator : {dda::thesis_integrator(), dda::generalized_alpha_integrator(0)}) {
    for (const double dt : {4e-3, 1e-3, 2.5e-4}) {
      dda::Model model;
      model.materials = {rock};
      model.joints = {dry_joint(std::atan(friction))};
      hold_corners(model, add_box(model, -1, -1, 4, 0));
      add_box(model, 0, 0, 1, height);
      model.gravity = {0, -standard_gravity};
      model.blocks[1].initial_velocity = {velocity, 0};
      model.stages = {moving_stage(integrator, dt, 1)};
      WatchedRun run(std::move(model));
      run.run_to_end();
      const double slip = run.state().displacement[1](0);
      const double expected = exact::stopping_distance(velocity, friction, standard_gravity);
      // Friction force and its arm over contact springs (0.4 of 10 E each), shear modulus and normal springs.
      const double force = friction * rock.density * standard_gravity * height;
      const double recoil = force * (1 / (2 * 4 * rock.young) + height / 4 * 2 * (1 + rock.poisson) / rock.young +
                                     height * height / 4 / (0.5 * 10 * rock.young));
      const std::string name = fmt::format("{}, dt = {} s", integrator.name, dt);
      outcome.assertions.push_back(
          expect("distance to rest, " + name, "m")
              .is(slip)
              .against(expected, "v0^2/(2 mu g)")
              .within(2 * recoil / expected,
                      "theory: the block leans by its friction force over the stiffness of contacts, "
                      "shear and rocking while it slides and is upright at rest; twice that"));
      outcome.assertions.push_back(energy_assertion(name, run.energy_residual()));
      outcome.counters += run.simulation().counters();
    }
  }
  return outcome;
}

}  // namespace

std::vector<Case> sliding_cases() {
  return {{"incline-sliding", "Block that slides down an incline of 30 degrees", {9}, CaseLabel::fast, slide_down},
          {"incline-sticking", "Block that friction holds on an incline of 30 degrees", {9}, CaseLabel::fast, stay},
          {"incline-creep",
           "Block that friction holds does not creep under any integrator",
           {9},
           CaseLabel::fast,
           stay_under_every_integrator},
          {"sliding-to-rest", "Block that friction stops on a level plane", {12}, CaseLabel::fast, slide_to_rest}};
}

}  // namespace verify
