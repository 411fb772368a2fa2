#include "verification/cases/excavation_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "engine/advice/ramp_of_removal.h"
#include "engine/model/energy_release.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/cavity_mesh.h"
#include "verification/cases/opening_mesh.h"
#include "verification/exact/pressurised_cavity.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/cavity.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double pressure = 10e6;  // Pa

// A static stage in which the rock is whole and at rest, and one that removes the last block, the core.
void remove_core(dda::Model& model, const dda::Integrator& integrator, double dt, double duration) {
  set_stage(model, integrator, dt, duration);
  dda::Stage whole = model.stages[0];
  whole.name = "whole";
  whole.integrator = dda::static_integrator();
  whole.dt = whole.duration = 1e-2;
  model.stages.insert(model.stages.begin(), whole);
  model.stages[1].removal.blocks = {static_cast<int>(model.blocks.size()) - 1};
  dda::finish_model(model);
}

// --- Kirsch ---

Assertion nothing_slips(const dda::Simulation& simulation, const FarStress& far) {
  const double stored = far.size() * far.size() / cavity_young;  // of a square metre
  const double friction = simulation.energy().friction;
  return expect("work of friction, over the energy stored in 1 m2", "-")
      .is(friction / stored)
      .against(0, "joints that stick throughout")
      .absolutely()
      .within(1e-12, "round-off");
}

// Largest errors, times what they fall with.
struct Tolerances {
  double rms, order_off;       // by the square of the blocks' size
  double wall, order_at_wall;  // of the hoop stress
  std::string said;
};

Outcome kirsch_removed_from(const std::vector<dda::JointMaterial>& joints, const Tolerances& allowed) {
  Outcome outcome;
  for (const double k0 : {0.5, 1.0, 2.0}) {
    const FarStress far{-k0 * pressure, -pressure};
    double coarser = 0;
    for (const int sectors : {32, 64}) {
      dda::Model model = filled(sectors, 6);
      if (!joints.empty()) model.joints = joints;
      for (dda::Block& block : model.blocks) block.initial_stress = {far.xx, far.yy, 0};
      hold_outside(model, far);
      remove_core(model, dda::static_integrator(), 1, 1);
      dda::Simulation simulation(model);
      advance_to_end(simulation);
      outcome.counters += simulation.counters();
      const double error = mean_error(simulation, far);
      outcome.assertions.push_back(
          expect(fmt::format("stresses from 1.2 to 4 radii, k0 = {}, {} sectors (error: rms, of the larger far stress)",
                             k0, sectors),
                 "MPa")
              .is(error * far.size() / 1e6)
              .against(0, "Kirsch 1898")
              .off_by(error)
              .within(allowed.rms * std::pow(16.0 / sectors, 2), "measured with margin; falls as their square"));
      if (sectors == 64) outcome.assertions.back().order = Order{order(coarser, error), 2, allowed.order_off};
      const double wall = wall_stress(simulation, static_cast<std::size_t>(sectors));
      const double expected = 3 * far.yy - far.xx;
      const double most = std::max(std::abs(expected), std::abs(3 * far.xx - far.yy));
      outcome.assertions.push_back(
          expect(fmt::format("hoop stress at the wall, k0 = {}, {} sectors (error: of the largest there)", k0, sectors),
                 "MPa")
              .is(wall / 1e6)
              .against(expected / 1e6, "3 s_yy - s_xx (Kirsch 1898)")
              .off_by((wall - expected) / most)
              .within(allowed.wall * std::pow(16.0 / sectors, allowed.order_at_wall), allowed.said));
      if (!joints.empty()) outcome.assertions.push_back(nothing_slips(simulation, far));
      coarser = error;
    }
  }
  return outcome;
}

Outcome kirsch_by_removal() {
  return kirsch_removed_from({}, {0.012, 0.2, 0.2, 2, "measured with margin; falls as their square"});
}

// Joints without cohesion or strength, but so rough that the shear on them, at most 1.2 times the pressure (beside the
// wall, k0 = 0.5 and 2), moves none.
Outcome kirsch_in_dry_rock() {
  dda::JointMaterial dry;
  dry.law = dda::InterfaceLaw::projected;
  dry.friction_angle = std::atan(2.0);
  return kirsch_removed_from({dry}, {0.016, 0.3, 0.2, 1, "measured with margin; falls as they do"});
}

// --- Tractions that stay ---

// Largest displacement of what stays, over p a/(2 G), while what the removed block exerted goes on at its full size.
Outcome kept_tractions() {
  Outcome outcome;
  for (const dda::Integrator& integrator : {dda::static_integrator(), dda::trapezoidal_integrator()}) {
    dda::Model model = filled(32, 5);
    const dda::Vec3 stress(-0.5 * pressure, -pressure, 0.2 * pressure);
    for (dda::Block& block : model.blocks) block.initial_stress = stress;
    hold_outside(model, stress);
    const double dt = integrator.is_static ? 1e-2 : 1e-4;  // nothing holds the ring but its inertia
    remove_core(model, integrator, dt, 100 * dt);
    model.stages[1].removal.relaxation = dda::PiecewiseLinear{{0, 1}, {1, 1}};
    dda::Simulation simulation(model);
    advance_to_end(simulation);
    outcome.counters += simulation.counters();
    double largest = 0;
    for (const dda::Vec6& u : simulation.state().displacement) largest = std::max(largest, u.head<2>().norm());
    const double let_go = pressure * (1 + cavity_poisson) / cavity_young;
    outcome.assertions.push_back(
        expect(fmt::format("largest displacement in 100 steps, {} (error: of p a/(2 G))", integrator.name), "m")
            .is(largest)
            .against(0, "the block removed is replaced by what it exerted")
            .off_by(largest / let_go)
            .within(1e-10, "round-off"));
  }
  return outcome;
}

// --- A circle removed at once ---

struct SuddenRock {
  double poisson = 0;
  double peak_hoop = 0;  // over p
  double when = 0;       // c_p t/a
  double overshoot = 0;  // of the displacement of the wall, over p a/(2 G)
};

// Published values; derived again by the finite differences of exact/pressurised_cavity, see its test.
constexpr SuddenRock rocks[] = {{0.2, 2.227, 3.8, 0.182}, {0.25, 2.255, 4.1, 0.191}, {0.3, 2.292, 4.5, 0.204}};

constexpr double outer_radius = 5;  // m; what comes back from there is at the wall after 8 a/c_p

dda::Model hydrostatic(int sectors, double poisson) {
  dda::Model model = filled(sectors, outer_radius);
  model.materials[0].poisson = poisson;
  for (dda::Block& block : model.blocks) block.initial_stress = {-pressure, -pressure, 0};
  hold_outside(model, dda::Vec3(-pressure, -pressure, 0));
  absorb_outside(model);
  return model;
}

double p_speed(double poisson) { return exact::p_speed_plane_strain(cavity_young, poisson, cavity_density); }
double shear_modulus(double poisson) { return cavity_young / (2 * (1 + poisson)); }

// The largest values at the wall on the x axis in the dynamic stage, and when they come.
struct Peaks {
  double hoop = 0, hoop_time = 0;  // Pa, s
  double displacement = 0;         // m, inwards
};

Peaks peaks_of(dda::Simulation& simulation, std::size_t sectors) {
  const dda::Model& model = simulation.model();
  const dda::Ring& ring = model.blocks[0].shape.outer;
  const dda::Vec2 wall(std::ranges::min(ring, {}, &dda::Vec2::norm).x(), 0);
  advance(simulation, 1);
  const double start = simulation.state().time;
  Peaks peaks;
  while (!simulation.finished()) {
    advance(simulation, 1);
    const double hoop = -wall_stress(simulation, sectors);
    if (hoop > peaks.hoop) peaks = {hoop, simulation.state().time - start, peaks.displacement};
    peaks.displacement = std::max(peaks.displacement, -dda::point_displacement(model, simulation.state(), 0, wall).x());
  }
  return peaks;
}

void assert_peaks(const SuddenRock& rock, int sectors, double tolerance, Outcome& outcome) {
  dda::Model model = hydrostatic(sectors, rock.poisson);
  const double speed = p_speed(rock.poisson);
  // Half of the time a wave takes through a block at the wall, and integration that takes what blocks do not carry.
  remove_core(model, dda::generalized_alpha_integrator(0.5), std::numbers::pi / sectors / speed, 6 / speed);
  dda::Simulation simulation(model);
  const Peaks peaks = peaks_of(simulation, static_cast<std::size_t>(sectors));
  outcome.counters += simulation.counters();
  const std::string what = fmt::format("nu = {}, {} sectors", rock.poisson, sectors);
  const double hoop = peaks.hoop / pressure;
  outcome.assertions.push_back(expect("largest hoop stress at the wall over p, " + what, "-")
                                   .is(hoop)
                                   .against(rock.peak_hoop, "wave equation in the radius; 2 when removed slowly")
                                   .within(tolerance, "measured with margin"));
  const double when = speed * peaks.hoop_time;
  outcome.assertions.push_back(expect("its time over a/c_P, " + what, "-")
                                   .is(when)
                                   .against(rock.when, "wave equation in the radius")
                                   .within(5e-2, "the peak is flat, its time known to 0.05"));
  const double still = pressure / (2 * shear_modulus(rock.poisson));
  const double overshoot = peaks.displacement / still;
  outcome.assertions.push_back(expect("largest displacement of the wall over p a/(2 G), " + what, "-")
                                   .is(overshoot)
                                   .against(1 + rock.overshoot, "wave equation in the radius")
                                   .within(tolerance / 2, "measured with margin"));
}

// Where the energy went when all has come to rest, over pi a^2 p^2/(2 G), which endless rock radiates.
void assert_energies(const SuddenRock& rock, int sectors, Outcome& outcome) {
  dda::Model model = hydrostatic(sectors, rock.poisson);
  const double speed = p_speed(rock.poisson);
  remove_core(model, dda::generalized_alpha_integrator(0.5), std::numbers::pi / sectors / speed, 100 / speed);
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  const dda::EnergyLedger& energy = simulation.energy();
  const double unit = std::numbers::pi * pressure * pressure / (2 * shear_modulus(rock.poisson));
  const std::string what = fmt::format("nu = {}, {} sectors", rock.poisson, sectors);
  const auto add = [&](const std::string& name, double value, double expected, const std::string& source,
                       double tolerance, const std::string& reason) {
    outcome.assertions.push_back(expect(name + " over pi a^2 p^2/(2 G), " + what, "-")
                                     .is(value / unit)
                                     .against(expected, source)
                                     .within(tolerance, reason));
  };
  add("energy removed", energy.removed, 1 - 2 * rock.poisson, "strain energy of the rock in the circle", 1e-9,
      "round-off: the polygon has the circle's area");
  // The wall of a ring under a dead load outside goes further in than that of endless rock, by this factor; its
  // tractions, let go at once, did half of their work.
  const double share = 1 / (outer_radius * outer_radius);
  const double further = (1 + (1 - 2 * rock.poisson) * share) / (1 - share);
  const double radiated = energy.radiated + energy.numerical;
  add("energy radiated", radiated, further, "half of p times the area that the wall closes, ring of 5 a (Lame)", 1e-2,
      "measured with margin");
  // By what was brought and not kept, of which nothing was radiated or removed: the other form of the same.
  const dda::EnergyRelease release = dda::energy_release(energy);
  add("energy released, W - (Uc + Ub + Wj + Wp)", release.by_work(), further + 1 - 2 * rock.poisson,
      "half of p times the area closed, and the strain energy removed; 2 (1 - nu) in endless rock", 1e-2,
      "measured with margin");
  add("work of the far stress", energy.external_work, 4 * (1 - rock.poisson) / (1 - share),
      "p times the area that the outside closes (Lame); 4 (1 - nu), twice what is released, in endless rock", 1e-2,
      "measured with margin");
  outcome.assertions.push_back(expect("both forms of the energy released, over the largest entry, " + what, "-")
                                   .is(release.relative_difference())
                                   .against(0, "0 (error absolute)")
                                   .absolutely()
                                   .within(1e-9, "round-off"));
  outcome.assertions.push_back(expect("kinetic energy at the end over that radiated, " + what, "-")
                                   .is(energy.kinetic / unit)
                                   .against(0, "rest")
                                   .absolutely()
                                   .within(1e-6, "the dashpots have taken it"));
  outcome.assertions.push_back(expect("residual of the ledger, " + what, "-")
                                   .is(energy.relative_residual())
                                   .against(0, "0 (error absolute)")
                                   .absolutely()
                                   .within(1e-9, "round-off"));
}

Outcome sudden_removal() {
  Outcome outcome;
  for (const SuddenRock& rock : rocks) {
    assert_peaks(rock, 64, 5e-3, outcome);
    assert_energies(rock, 32, outcome);
  }
  return outcome;
}

Outcome fine_sudden_removal() {
  Outcome outcome;
  for (const SuddenRock& rock : rocks) assert_peaks(rock, 128, 2e-3, outcome);
  return outcome;
}

// What `dda check` foretells of an opening that is taken out over a time: against finite differences in the radius, and
// what the wall of rings of blocks does against both. Nothing has come back from the outside when the wall has its
// peak.
double overshoot_by_waves(const SuddenRock& rock, double ramp) {
  const double shear = shear_modulus(rock.poisson);
  const double speed = p_speed(rock.poisson);
  const exact::Cavity cavity{1, cavity_density * speed * speed, shear, cavity_density};
  const auto pull = [&](double t) { return -std::min(1.0, t * speed / ramp); };
  const exact::CavityMotion motion = exact::pressurised_cavity(cavity, pull, {1}, (ramp + 8) / speed, 100);
  double closed = 0, most = 0;
  for (const double velocity : motion.histories[0].velocity) {
    closed -= motion.interval * velocity;
    most = std::max(most, closed);
  }
  return most * 2 * shear - 1;
}

double overshoot_of_blocks(const SuddenRock& rock, double ramp, Outcome& outcome) {
  constexpr int sectors = 64;
  dda::Model model = hydrostatic(sectors, rock.poisson);
  const double speed = p_speed(rock.poisson);
  remove_core(model, dda::generalized_alpha_integrator(0.5), std::numbers::pi / sectors / speed, 8 / speed);
  model.stages[1].removal.relaxation = dda::PiecewiseLinear{{0, ramp / speed}, {1, 0}};
  dda::Simulation simulation(model);
  const Peaks peaks = peaks_of(simulation, sectors);
  outcome.counters += simulation.counters();
  return peaks.displacement * 2 * shear_modulus(rock.poisson) / pressure - 1;
}

Outcome slow_removal() {
  Outcome outcome;
  for (const SuddenRock& rock : rocks)
    for (const double ramp : {2.0, 4.0, 20.0, 90.0}) {
      const double foretold = dda::wall_overshoot((1 - rock.poisson) / (1 - 2 * rock.poisson), ramp);
      const std::string what = fmt::format("nu = {}, over {} a/c_P", rock.poisson, ramp);
      outcome.assertions.push_back(expect("overshoot of the wall that is foretold, " + what, "-")
                                       .is(foretold)
                                       .against(overshoot_by_waves(rock, ramp), "wave equation in the radius")
                                       .absolutely()
                                       .within(1e-3, "3e-4 of the inversion, the rest of rings of a/100"));
      if (ramp > 4) continue;  // what comes back from the outside would be at the wall before its peak
      outcome.assertions.push_back(expect("overshoot of the wall of 64 sectors, " + what, "-")
                                       .is(overshoot_of_blocks(rock, ramp, outcome))
                                       .against(foretold, "foretold")
                                       .absolutely()
                                       .within(5e-3, "measured with margin"));
    }
  return outcome;
}

}  // namespace

std::vector<Case> excavation_cases() {
  return {
      {"kirsch-removed", "A circle removed under a biaxial field", {28}, CaseLabel::fast, kirsch_by_removal},
      {"kirsch-dry", "A circle removed from dry rock that sticks", {28}, CaseLabel::fast, kirsch_in_dry_rock},
      {"removed-tractions-kept", "A circle removed whose tractions stay", {31}, CaseLabel::fast, kept_tractions},
      {"sudden-removal", "A circle removed at once under hydrostatic stress", {41}, CaseLabel::fast, sudden_removal},
      {"slow-removal", "A circle removed over a time", {41}, CaseLabel::fast, slow_removal},
      {"sudden-removal-fine", "The same in a fine mesh", {41}, CaseLabel::slow, fine_sudden_removal}};
}

}  // namespace verify
