#include "verification/cases/bolt_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/geometry/rotation.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "verification/exact/rock_bolt.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr const char* rock =
    R"("dda": 1, "materials": {"rock": {"density": 2600, "young": "50 GPa", "poisson": 0.25}})";

dda::Model model_of(const std::string& scene) {
  return dda::parse_scene("{" + std::string(rock) + ", " + scene + "}", "bolts");
}

double bolt_force_in(const dda::Simulation& simulation) { return simulation.bolts().state(0, 0).force(0); }

// --- The law: two held blocks, pulled apart, pushed together, pulled apart further ---

constexpr exact::RockBolt cable{4e7, 5e4, 1.2e5};

double elongation_at(double t) {  // out to 4 mm, back to -3 mm, out to 6 mm
  const double leg = 0.1;
  if (t <= leg) return 4e-3 * t / leg;
  if (t <= 2 * leg) return 4e-3 - 7e-3 * (t - leg) / leg;
  return -3e-3 + 9e-3 * (t - 2 * leg) / leg;
}

Outcome force_law() {
  Outcome outcome;
  for (const std::string kinematics : {"small", "finite"}) {
    const dda::Model model = model_of(fmt::format(
        R"("blocks": [{{"polygon": {{"name": "left", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}}}},
                      {{"polygon": {{"name": "right", "vertices": [[3, 0], [4, 0], [4, 1], [3, 1]]}}}}],
           "fixed": ["left"],
           "supports": [{{"block": "right", "displacement": ["1 mm", 0],
                          "history": {{"table": [[0, 0], [0.1, 4], [0.2, -3], [0.3, 6]]}}}}],
           "bolts": [{{"from": [0.5, 0.5], "to": [3.5, 0.5], "stiffness": {}, "pretension": {}, "yield_force": {}}}],
           "steps": {{"dt": 1e-3, "duration": 0.3, "kinematics": "{}", "integrator": "thesis"}})",
        cable.stiffness, cable.pretension, cable.yield_force, kinematics));
    dda::Simulation simulation(model);
    double worst = 0, largest = 0;
    while (!simulation.finished()) {
      advance(simulation, 1);
      const double elongation = elongation_at(simulation.state().time);
      largest = std::max(largest, elongation);
      keep_largest(worst, bolt_force_in(simulation) - exact::bolt_force(cable, elongation, largest));
    }
    outcome.counters += simulation.counters();
    outcome.assertions.push_back(expect("largest error of the force, " + kinematics + " kinematics", "N")
                                     .is(worst)
                                     .against(0, "elastic, perfectly plastic, slack (verification/exact/rock_bolt.h)")
                                     .off_by(worst / cable.yield_force)
                                     .within(1e-12, "of the yield force: round-off of displacements times stiffness"));
    const double dissipated = simulation.energy().plastic;
    const double expected = cable.yield_force * exact::plastic_elongation(cable, largest);
    outcome.assertions.push_back(expect("dissipated by yielding, " + kinematics + " kinematics", "J/m")
                                     .is(dissipated)
                                     .against(expected, "yield force times plastic elongation")
                                     .within(1e-12, "round-off"));
  }
  return outcome;
}

// --- A block hung from a roof, and three from one another ---

Outcome hung_blocks() {
  Outcome outcome;
  const dda::Model model = model_of(
      R"("blocks": [{"polygon": {"name": "roof", "vertices": [[0, 3], [4, 3], [4, 4], [0, 4]]}},
                    {"grid": {"name": "slab", "origin": [1, 0], "columns": 1, "rows": 3, "block_width": 2, "block_height": 1}}],
         "fixed": ["roof"], "gravity": 10,
         "bolts": [{"name": "grouted", "from": [2, 3.5], "to": [2, 0.2], "grouted": true, "stiffness": "20 MN/m",
                    "pretension": "10 kN", "spacing": 0.5}],
         "measurements": [{"name": "top", "quantity": "bolt_force", "bolt": "grouted", "point": [2, 3]},
                          {"name": "middle", "quantity": "bolt_force", "bolt": "grouted", "point": [2, 2]},
                          {"name": "bottom", "quantity": "bolt_force", "bolt": "grouted", "point": [2, 1]}],
         "steps": {"dt": 0.1, "duration": 40, "integrator": "static"})");
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  double below = 0;
  for (int joint = 2; joint >= 0; --joint) {
    below += 2600 * 2 * 10;
    const auto link = static_cast<std::size_t>(joint);
    const double force = simulation.bolts().state(0, link).force(0);
    outcome.assertions.push_back(expect(fmt::format("force per metre at joint {} from the top", joint + 1), "N/m")
                                     .is(force)
                                     .against(below, "weight below the joint")
                                     .within(1e-9, "what static steps leave out of balance"));
    const double opening = simulation.bolts().elongation(0, link);
    const double expected = (below - 20e3) / 40e6;
    outcome.assertions.push_back(expect(fmt::format("opening of joint {} from the top", joint + 1), "m")
                                     .is(opening)
                                     .against(expected, "(weight below - pretension)/stiffness, each over the spacing")
                                     .off_by((opening - expected) / 1e-3)
                                     .within(1e-8, "of 1 mm: what static steps leave out of balance"));
  }
  return outcome;
}

// --- A block on an incline held by a bolt at its yield force ---

constexpr double slope = 35 * degree;
constexpr double friction_angle = 20 * degree;
constexpr double weight = 2600 * 1 * 0.6 * 9.81;
constexpr int settling_steps = 200;
constexpr double released_dt = 5e-4;

// In axes along and square to the slope, uphill positive.
std::string placed(double along, double up) {
  const dda::Vec2 point = dda::rotation(slope) * dda::Vec2(along, up);
  return fmt::format("[{:.17g}, {:.17g}]", point.x(), point.y());
}

std::string box(double left, double bottom, double right, double top) {
  return fmt::format("[{}, {}, {}, {}]", placed(left, bottom), placed(right, bottom), placed(right, top),
                     placed(left, top));
}

// The bolt goes from the block's middle, at `inclination` into the slope, to the rock below or to a block on it. On
// springs, which are ten times as stiff as the block: a projected joint turns with half of the tilt by which the block
// strains on its bed, p/E = 2e-7 rad, and where a hundredth of T is missing that is 2e-5 of the acceleration.
dda::Model bolted_block(double inclination, double force, double duration) {
  const double reach = 3.5;
  return model_of(fmt::format(
      R"("joints": {{"default": {{"friction_angle": "20 deg", "law": "classical"}}}},
         "blocks": [{{"polygon": {{"name": "slope", "vertices": {}}}}}, {{"polygon": {{"name": "anchor", "vertices": {}}}}},
                    {{"polygon": {{"name": "block", "vertices": {}}}}}],
         "fixed": ["slope", "anchor"], "gravity": 9.81,
         "bolts": [{{"from": {}, "to": {}, "stiffness": "1 MN/m", "pretension": {}, "yield_force": {}}}],
         "steps": [{{"name": "settle", "integrator": "static", "dt": 0.01, "duration": 2, "strength": "unlimited"}},
                   {{"name": "let go", "dt": {}, "duration": {}}}])",
      box(-3, -3, 6, 0), box(3.5, 0, 4.5, 1), box(0, 0, 1, 0.6), placed(0.5, 0.3),
      placed(0.5 + reach * std::cos(inclination), 0.3 - reach * std::sin(inclination)), force, force, released_dt,
      duration));
}

// The block's motion down the slope.
double down_slope(const dda::Vec2& motion) { return -(dda::rotation(-slope) * motion).x(); }

struct Released {
  double position = 0, speed = 0;
};

// After the static stage: at `first` and at the end.
std::pair<Released, Released> release(const dda::Model& model, double first, dda::Counters& counters) {
  dda::Simulation simulation(model);
  const auto now = [&simulation]() -> Released {
    return {down_slope(simulation.state().displacement[2].head<2>()),
            down_slope(simulation.state().velocity[2].head<2>())};
  };
  advance(simulation, settling_steps + static_cast<int>(std::lround(first / released_dt)));
  const Released start = now();
  advance_to_end(simulation);
  counters += simulation.counters();
  return {start, now()};
}

Outcome incline() {
  Outcome outcome;
  for (const double inclination : {0.0, 20 * degree}) {
    const double limit = exact::bolt_force_on_incline(weight, slope, friction_angle, inclination);
    const std::string text = fmt::format("bolt at {:.0f} deg to the slope, ", inclination / degree);
    const std::string source = "T = W (sin a - cos a tan f)/(cos b + sin b tan f)";
    const auto [held, still_held] = release(bolted_block(inclination, 1.01 * limit, 1), 0.5, outcome.counters);
    const double crept = still_held.position - held.position;
    outcome.assertions.push_back(expect(text + "slid between 0.5 s and 1 s at 1.01 T", "m")
                                     .is(crept)
                                     .against(0, source + " holds (error absolute)")
                                     .absolutely()
                                     .within(1e-9, "no creep"));
    const auto [start, end] = release(bolted_block(inclination, 0.99 * limit, 0.15), 0.05, outcome.counters);
    const double pull = std::cos(inclination) + std::sin(inclination) * std::tan(friction_angle);
    const double expected = 0.01 * limit * pull / (weight / 9.81) * 0.1;
    const double gained = end.speed - start.speed;
    outcome.assertions.push_back(
        expect(text + "speed gained from 0.05 s to 0.15 s at 0.99 T", "m/s")
            .is(gained)
            .against(expected, source + "; what is missing accelerates the block")
            .within(1e-5, "measured 5e-7: what is left of the block's ringing on its springs"));
  }
  return outcome;
}

// --- A block thrown against a bolt that yields ---

constexpr exact::RockBolt soft{2e7, 0, 8e4};
constexpr double speed = 0.5;

// Largest plastic elongation against the closed form; relative.
double error_of_impact(double dt, Outcome& outcome) {
  const dda::Model model = model_of(fmt::format(
      R"("blocks": [{{"polygon": {{"name": "base", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}}}},
                    {{"polygon": {{"vertices": [[3, 0], [4, 0], [4, 1], [3, 1]], "initial_velocity": [{}, 0]}}}}],
         "fixed": ["base"],
         "bolts": [{{"from": [0.5, 0.5], "to": [3.5, 0.5], "stiffness": {}, "yield_force": {}}}],
         "steps": {{"dt": {}, "duration": 0.06, "integrator": "trapezoidal", "kinematics": "small"}})",
      speed, soft.stiffness, soft.yield_force, dt));
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  const dda::EnergyLedger& energy = simulation.energy();
  outcome.assertions.push_back(expect(fmt::format("energy residual, dt = {:g} s", dt), "J/m")
                                   .is(energy.residual())
                                   .against(0, "work = stored + dissipated")
                                   .off_by(energy.relative_residual())
                                   .within(1e-11, "of the largest term: round-off of 150 to 2400 steps"));
  return relative_error(simulation.bolts().state(0, 0).plastic(0),
                        exact::plastic_elongation_of_impact(soft, 2600, speed));
}

Outcome impact() {
  Outcome outcome;
  for (const double dt : {4e-4, 1e-4, 2.5e-5}) {
    const double error = error_of_impact(dt, outcome);
    const double expected = exact::plastic_elongation_of_impact(soft, 2600, speed);
    outcome.assertions.push_back(
        expect(fmt::format("plastic elongation, dt = {:g} s", dt), "m")
            .is((1 + error) * expected)
            .against(expected,
                     "kinetic energy = N_y^2/(2 k) + N_y times plastic elongation (verification/exact/rock_bolt.h)")
            .off_by(error)
            .within(std::pow(dt * speed * soft.stiffness / soft.yield_force, 2),
                    "square of the share of the elastic range that a step takes: yielding begins within a step"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> bolt_cases() {
  return {{"bolt-on-incline",
           "A bolt holds a block on an incline above the limit force and lets it slide below",
           {9},
           CaseLabel::fast,
           incline},
          {"bolt-force-law",
           "A cable stretched, slackened and stretched again: force and dissipation",
           {8},
           CaseLabel::fast,
           force_law},
          {"bolt-impact", "A block thrown against a bolt that yields", {8}, CaseLabel::fast, impact},
          {"bolt-hung-blocks",
           "Blocks hung from a roof by a grouted bolt with pretension",
           {23},
           CaseLabel::fast,
           hung_blocks}};
}

}  // namespace verify
