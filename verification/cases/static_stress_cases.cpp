#include "verification/cases/static_stress_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/end_reflection.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::Vec2;

constexpr double gravity = 9.81;
constexpr double settling_step = 10;  // s
constexpr std::size_t settling_steps = 10;

// ---- A column on end: x points down, the foot is at the right end.

BarCase column(dda::InterfaceLaw law) {
  BarCase bar = bonded_bar(law, dda::generalized_alpha_integrator(0.8), 2e-5, 0);
  bar.blocks = 80;
  bar.probes = {55};
  const double speed = exact::bar_speed(bar.rock.young, bar.rock.density);
  bar.end_impedance = bar.rock.density * speed * bar.height;
  return bar;
}

EndReflection path_of(const BarCase& bar) {
  const double speed = exact::bar_speed(bar.rock.young, bar.rock.density);
  return {bar.probes[0] + 0.5, 1.0 * bar.blocks, speed, 16 / speed, bar.stage.dt};
}

dda::TimeFunction later(const dda::TimeFunction& history, double delay) {
  auto table = std::get<dda::PiecewiseLinear>(history);
  for (double& time : table.times) time += delay;
  return table;
}

// Settles on rollers under its foot, which then give way to the dashpots there.
dda::Model settled_first(const BarCase& bar) {
  dda::Model model = model_of(bar);
  model.gravity = {gravity, 0};
  const int last = bar.blocks - 1;
  for (const double y : {0.0, bar.height}) {
    dda::PointSupport support{last, {1.0 * bar.blocks, y}, true, false, 500 * bar.rock.young, Vec2::Zero(), {}};
    support.last_stage = 0;
    model.supports.push_back(support);
  }
  for (dda::ViscousEdge& edge : model.viscous_edges) edge.first_stage = 1;
  dda::Stage settle = model.stages[0];
  settle.name = "settle";
  settle.integrator = dda::static_integrator();
  settle.dt = settling_step;
  settle.duration = static_cast<double>(settling_steps) * settling_step;
  model.stages.insert(model.stages.begin(), settle);
  model.edge_loads[0].history = later(model.edge_loads[0].history, settle.duration);
  dda::finish_model(model);
  return model;
}

// What the wave adds to the stress of the probe.
std::vector<double> wave_of(const dda::Model& model, dda::Counters& counters) {
  RecordedRun run = record_run(model);
  counters += run.counters;
  const std::vector<double>& whole = run.histories.at(0);
  const double settled = whole.at(settling_steps);
  std::vector<double> wave;
  for (std::size_t i = settling_steps; i < whole.size(); ++i) wave.push_back(whole[i] - settled);
  return wave;
}

void assert_rest(BarCase bar, Outcome& outcome) {
  bar.steps = 500;
  bar.push = [](double) { return 0.0; };
  dda::Simulation simulation(settled_first(bar));
  advance(simulation, static_cast<int>(settling_steps));
  double fastest = 0;
  for (int i = 0; i < bar.steps; ++i) {
    advance(simulation, 1);
    for (const dda::Vec6& velocity : simulation.state().velocity) keep_largest(fastest, velocity.head<2>().norm());
  }
  outcome.counters += simulation.counters();
  const double fall = gravity * bar.steps * bar.stage.dt;
  outcome.assertions.push_back(
      expect(fmt::format("velocity after the rollers have gone, over that of a free fall, {}", name_of(bar.joint.law)),
             "-")
          .is(fastest / fall)
          .against(0, "equilibrium")
          .absolutely()
          .within(1e-9, "round-off of the static solution, whose springs are 1000 E beside joints of E"));
}

Outcome under_weight() {
  Outcome outcome;
  for (const dda::InterfaceLaw law :
       {dda::InterfaceLaw::classical, dda::InterfaceLaw::consistent, dda::InterfaceLaw::cubic}) {
    BarCase bar = column(law);
    assert_rest(bar, outcome);
    const EndReflection end = path_of(bar);
    bar.push = smooth_push(1e6, end.pulse);
    bar.steps = static_cast<int>(end.duration() / bar.stage.dt);
    const std::vector<double> weightless = engine_histories(bar, outcome.counters)[0];
    const std::vector<double> wave = wave_of(settled_first(bar), outcome.counters);
    const double difference = largest_difference(wave, weightless);
    outcome.assertions.push_back(
        expect(fmt::format("largest difference of a pulse from that in a column without weight, of the peak, {}",
                           name_of(law)),
               "-")
            .is(difference)
            .against(0, "superposition")
            .absolutely()
            .within(1e-9, "as above"));
  }
  return outcome;
}

// ---- In-situ stress: a square of blocks with dashpots all around.

std::string stressed_square(const std::string& joint, const std::string& pattern, const std::string& kinematics) {
  return R"({
  "dda": 1, "plane": "strain",
  "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
  "joints": {"default": )" +
         joint + R"(},
  "blocks": {"grid": {"columns": 12, "rows": 12, "block_width": 1, "block_height": 1, "pattern": ")" +
         pattern + R"(",
                      "initial_stress": {"xx": "-20 MPa", "yy": "-10 MPa", "xy": "4 MPa"}}},
  "viscous_boundaries": [{"edge": "left", "carries_initial_stress": true},
                         {"edge": "right", "carries_initial_stress": true},
                         {"edge": "top", "carries_initial_stress": true},
                         {"edge": "bottom", "carries_initial_stress": true}],
  "steps": {"dt": "50 us", "duration": "10 ms", "kinematics": ")" +
         kinematics + R"("}
})";
}

void assert_stays(const std::string& scene, Outcome& outcome, const std::string& which) {
  dda::Simulation simulation(dda::parse_scene(scene, "stressed square"));
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  const double stress = 20e6;
  const double speed = stress / (2650 * exact::p_speed_plane_strain(50e9, 0.25, 2650));  // m/s, were it set free
  double fastest = 0;
  double change = 0;
  for (std::size_t i = 0; i < simulation.state().velocity.size(); ++i) {
    keep_largest(fastest, simulation.state().velocity[i].head<2>().norm());
    keep_largest(change, (simulation.state().stress[i] - simulation.model().blocks[i].initial_stress).norm());
  }
  outcome.assertions.push_back(expect("velocity in 20 MPa of in-situ stress, over stress/(rho c_p), " + which, "-")
                                   .is(fastest / speed)
                                   .against(0, "equilibrium")
                                   .absolutely()
                                   .within(1e-12, "round-off"));
  outcome.assertions.push_back(expect("change of stress, over the stress, " + which, "-")
                                   .is(change / stress)
                                   .against(0, "equilibrium")
                                   .absolutely()
                                   .within(1e-12, "round-off"));
}

Outcome in_situ() {
  Outcome outcome;
  assert_stays(stressed_square(R"({"bonded": true})", "stack", "small"), outcome, "bonded squares");
  assert_stays(stressed_square(R"({"bonded": true, "law": "classical"})", "stack", "small"), outcome,
               "squares bonded by springs");
  for (const char* kinematics : {"small", "finite"})
    assert_stays(stressed_square(R"({"friction_angle": "35 deg"})", "running_bond", kinematics), outcome,
                 fmt::format("dry bricks, {} kinematics", kinematics));
  return outcome;
}

}  // namespace

std::vector<Case> static_stress_cases() {
  return {{"viscous-edge-under-weight",
           "A column settles on rollers that give way to a viscous edge; a pulse passes out",
           {34},
           CaseLabel::fast,
           under_weight},
          {"viscous-edge-in-situ", "In-situ stress between viscous edges", {34}, CaseLabel::fast, in_situ}};
}

}  // namespace verify
