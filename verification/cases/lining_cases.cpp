#include "verification/cases/lining_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/scene/scene.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/lined_hole.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

exact::LinedHole tunnel(double xx, double yy, double let_go) {
  exact::LinedHole hole;
  hole.radius = 2.5;
  hole.outer_radius = 10;
  hole.rock_young = 5e9;
  hole.rock_poisson = 0.25;
  hole.thickness = 0.2;
  hole.lining_young = 15e9;
  hole.lining_poisson = 0.2;
  hole.stress_xx = xx;
  hole.stress_yy = yy;
  hole.let_go = let_go;
  return hole;
}

// Radii of the corners of rings of blocks about as long as wide, so that the middles of the faces of the wall and of
// the outside lie on the circles.
std::string radii(const exact::LinedHole& hole, int sectors) {
  const double step = 2 * std::numbers::pi / sectors;
  const int rings = static_cast<int>(std::ceil(std::log(hole.outer_radius / hole.radius) / step));
  std::string text;
  for (int i = 0; i <= rings; ++i)
    text += fmt::format("{}{:.17g}", i == 0 ? "" : ", ",
                        hole.radius * std::pow(hole.outer_radius / hole.radius, 1.0 * i / rings) / std::cos(step / 2));
  return text;
}

std::string core(const exact::LinedHole& hole, int sectors) {
  const double step = 2 * std::numbers::pi / sectors;
  const double corner = hole.radius / std::cos(step / 2);
  std::string text;
  for (int i = 0; i < sectors; ++i)
    text += fmt::format("{}[{:.17g}, {:.17g}]", i == 0 ? "" : ", ", corner * std::cos(i * step),
                        corner * std::sin(i * step));
  return text;
}

// As a scene has it: rock under stress, a tunnel in it that lets go of its share and is lined then, and the rest goes.
// `strength` (Pa): of the concrete; 0: elastic.
dda::Model lined_tunnel(const exact::LinedHole& hole, int sectors, double strength) {
  const std::string concrete = strength > 0 ? fmt::format(R"(, "compressive_strength": {})", strength) : std::string();
  return dda::parse_scene(
      fmt::format(
          R"({{"dda": 1, "plane": "strain", "materials": {{"rock": {{"density": 2600, "young": {}, "poisson": {}}}}},
               "joints": {{"default": {{"bonded": true, "law": "consistent"}}}},
               "blocks": [{{"rings": {{"radii": [{}], "sectors": {}}}}},
                          {{"polygon": {{"name": "core", "vertices": [{}]}}}}],
               "stress_field": {{"xx": {}, "yy": {}}}, "loads": [{{"edge": "outside", "traction": "in-situ"}}],
               "linings": [{{"name": "shotcrete", "opening": "core", "thickness": {}, "young": {}, "poisson": {},
                             "from_stage": "lined"{}}}],
               "steps": [{{"name": "in situ", "integrator": "static", "dt": 1, "duration": 1, "kinematics": "small"}},
                         {{"name": "opened", "integrator": "static", "dt": 1, "duration": 2, "kinematics": "small",
                           "remove": {{"blocks": ["core"], "table": [[0, 1], [1, {}], [2, {}], [4, 0]]}}}},
                         {{"name": "lined", "integrator": "static", "dt": 1, "duration": 6, "kinematics": "small"}}]}})",
          hole.rock_young, hole.rock_poisson, radii(hole, sectors), sectors, core(hole, sectors), hole.stress_xx,
          hole.stress_yy, hole.thickness, hole.lining_young, hole.lining_poisson, concrete, 1 - hole.let_go,
          1 - hole.let_go),
      "lined tunnel");
}

// Largest errors over all elements, and the largest thrust.
struct RingErrors {
  double thrust = 0, moment = 0;  // N, N m
  double largest_thrust = 0;      // N
};

RingErrors errors_of(const dda::Simulation& simulation, const exact::RingForces& expected) {
  const dda::Lining& lining = simulation.model().linings[0];
  RingErrors errors;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const dda::Vec2 middle = (lining.start_of(i).point + lining.end_of(i).point) / 2;
    const double twice = std::cos(2 * std::atan2(middle.y(), middle.x()));
    const dda::SectionForces forces = dda::linings_of(simulation).forces(simulation.model(), 0, i);
    errors.thrust = std::max(errors.thrust, std::abs(forces.thrust - expected.thrust_0 - expected.thrust_2 * twice));
    errors.moment = std::max(errors.moment, std::abs(forces.moment() - expected.moment_2 * twice));
    errors.largest_thrust = std::max(errors.largest_thrust, forces.thrust);
  }
  return errors;
}

RingErrors run_ring(const exact::LinedHole& hole, int sectors, Outcome& outcome) {
  dda::Simulation simulation(lined_tunnel(hole, sectors, 0));
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  const double residual = simulation.energy().relative_residual();
  outcome.assertions.push_back(expect(fmt::format("residual of the ledger, {} faces", sectors), "-")
                                   .is(residual)
                                   .against(0, "0 (error absolute)")
                                   .absolutely()
                                   .within(1e-10, "round-off"));
  return errors_of(simulation, exact::lining_forces(hole));
}

constexpr auto source = "verification/exact/lined_hole: Lame, Navier, thin ring on the wall";

// --- Equal stresses from all sides ---

Outcome hydrostatic() {
  Outcome outcome;
  for (const double let_go : {0.0, 0.6}) {
    const exact::LinedHole hole = tunnel(-2e6, -2e6, let_go);
    const double expected = exact::lining_forces(hole).thrust_0;
    double coarser = 0;
    for (const int sectors : {16, 32, 64}) {
      const RingErrors errors = run_ring(hole, sectors, outcome);
      const double error = errors.thrust / expected;
      outcome.assertions.push_back(
          expect(fmt::format("thrust, {:g} % let go before, {} faces (error: largest of all elements)", 100 * let_go,
                             sectors),
                 "kN/m")
              .is(errors.largest_thrust / 1e3)
              .against(expected / 1e3, source)
              .off_by(error)
              .within(0.03 * std::pow(16.0 / sectors, 2), "measured with margin; falls as its square"));
      if (sectors == 64) outcome.assertions.back().order = Order{order(coarser, error), 2, 0.3};
      coarser = error;
      outcome.assertions.push_back(
          expect(
              fmt::format("moment over thrust times thickness, {:g} % let go before, {} faces", 100 * let_go, sectors),
              "-")
              .is(errors.moment / (expected * hole.thickness))
              .against(0, "0 (error absolute)")
              .absolutely()
              .within(1e-9, "all elements are alike"));
    }
    const double thick = exact::thick_ring_thrust(hole);
    outcome.assertions.push_back(
        expect(fmt::format("closed form of the thin ring, {:g} % let go before, against a ring inside of the wall",
                           100 * let_go),
               "kN/m")
            .is(expected / 1e3)
            .against(thick / 1e3, "Lame for rock and ring")
            .off_by(relative_error(expected, thick))
            .within(hole.thickness / hole.radius, "thickness over radius: the axis lies on the wall (ADR 55)"));
  }
  return outcome;
}

// --- Unequal stresses ---

Outcome biaxial() {
  Outcome outcome;
  for (const double k0 : {0.5, 2.0}) {
    const exact::LinedHole hole = tunnel(-k0 * 1e6, -1e6, 0.3);
    const exact::RingForces expected = exact::lining_forces(hole);
    const double largest = expected.thrust_0 + std::abs(expected.thrust_2);
    double coarser_thrust = 0, coarser_moment = 0;
    for (const int sectors : {16, 32, 64}) {
      const RingErrors errors = run_ring(hole, sectors, outcome);
      const std::string what = fmt::format(", k0 = {:g}, {} faces", k0, sectors);
      const double thrust = errors.thrust / largest;
      outcome.assertions.push_back(
          expect("error of the thrust" + what + " (of the largest)", "kN/m")
              .is(errors.thrust / 1e3)
              .against(0, source)
              .off_by(thrust)
              .within(0.03 * std::pow(16.0 / sectors, 2), "measured with margin; falls as its square"));
      const double moment = errors.moment / std::abs(expected.moment_2);
      outcome.assertions.push_back(expect("error of the moment" + what + " (of the largest)", "kN m/m")
                                       .is(errors.moment / 1e3)
                                       .against(0, source)
                                       .off_by(moment)
                                       .within(0.3 * std::pow(16.0 / sectors, 1.3),
                                               "measured with margin; moments are differences of turns (ADR 55)"));
      if (sectors == 64) {
        outcome.assertions[outcome.assertions.size() - 2].order = Order{order(coarser_thrust, thrust), 2, 0.3};
        outcome.assertions.back().order = Order{order(coarser_moment, moment), 1.3, 0.3};
      }
      coarser_thrust = thrust;
      coarser_moment = moment;
    }
  }
  return outcome;
}

// --- A ring that crushes ---

// How far the wall has come in since the lining is there: the mean over the middles of its faces.
double mean_convergence(const dda::Simulation& simulation) {
  double sum = 0;
  const dda::Lining& lining = simulation.model().linings[0];
  for (const dda::LiningNode& node : lining.nodes)
    sum -= dda::point_displacement(simulation.model(), simulation.state(), node.block, node.point)
               .dot(node.point.normalized());
  return sum / static_cast<double>(lining.nodes.size());
}

Outcome crushed() {
  Outcome outcome;
  const exact::LinedHole hole = tunnel(-20e6, -20e6, 0.3);
  const double strength = 10e6;
  const double crushing = strength * hole.thickness;
  const exact::CrushedRing expected = exact::crushed_ring(hole, crushing);
  double coarser = 0;
  for (const int sectors : {16, 32, 64}) {
    dda::Simulation simulation(lined_tunnel(hole, sectors, strength));
    advance(simulation, 3);
    const double before = mean_convergence(simulation);
    advance_to_end(simulation);
    outcome.counters += simulation.counters();
    const std::string what = fmt::format(", {} faces", sectors);
    const RingErrors errors = errors_of(simulation, {crushing, 0, 0});
    outcome.assertions.push_back(expect("thrust" + what, "kN/m")
                                     .is(errors.largest_thrust / 1e3)
                                     .against(crushing / 1e3, "strength times thickness")
                                     .off_by(errors.thrust / crushing)
                                     .within(1e-5, "the moments of a polygon, which take a share of the strength"));
    const double convergence = mean_convergence(simulation) - before;
    const double error = relative_error(convergence, expected.convergence);
    outcome.assertions.push_back(
        expect("convergence of the wall behind the lining" + what, "mm")
            .is(1e3 * convergence)
            .against(1e3 * expected.convergence, "Lame: rock under the pressure f_c h/a")
            .off_by(error)
            .within(0.03 * std::pow(16.0 / sectors, 2), "measured with margin; falls as its square"));
    if (sectors == 64) outcome.assertions.back().order = Order{order(coarser, error), 2, 0.3};
    coarser = error;
    const double dissipated = simulation.energy().plastic;
    outcome.assertions.push_back(
        expect("energy the crushed concrete takes" + what, "kJ/m")
            .is(dissipated / 1e3)
            .against(expected.dissipated / 1e3, "thrust times plastic shortening of the circumference")
            .off_by(relative_error(dissipated, expected.dissipated))
            .within(0.05 * std::pow(16.0 / sectors, 2), "measured with margin; falls as its square"));
    const double residual = simulation.energy().relative_residual();
    outcome.assertions.push_back(expect("residual of the ledger" + what, "-")
                                     .is(residual)
                                     .against(0, "0 (error absolute)")
                                     .absolutely()
                                     .within(1e-10, "round-off"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> lining_cases() {
  return {{"lining-hydrostatic",
           "A lining sprayed when a share of an equal stress is let go",
           {43},
           CaseLabel::fast,
           hydrostatic},
          {"lining-biaxial", "The same under unequal stresses: thrust and moment", {43}, CaseLabel::fast, biaxial},
          {"lining-crushed", "The same of concrete that is crushed all around", {43}, CaseLabel::fast, crushed}};
}

}  // namespace verify
