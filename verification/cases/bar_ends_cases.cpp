#include "verification/cases/bar_ends_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "verification/cases/bar_case.h"
#include "verification/cases/end_reflection.h"
#include "verification/exact/chain_modes.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::InterfaceLaw;

constexpr double young = 50e9;
constexpr double density = 2650;
const double speed = exact::bar_speed(young, density);
constexpr double pulse = 4e-3;  // s: 17 m
constexpr int blocks = 80;
constexpr int probe = 55;

// Impedance (N s/m) of the bar.
double impedance(const BarCase& bar) { return density * speed * bar.height; }

BarCase bar_with_end(InterfaceLaw law, const dda::Integrator& integrator, double dt) {
  BarCase bar = bonded_bar(law, integrator, dt, static_cast<int>(std::lround(0.030 / dt)));
  bar.blocks = blocks;
  bar.rock = {"rock", density, young, 0, dda::PlaneState::stress};
  bar.push = smooth_push(1e6, pulse);
  bar.probes = {probe};
  return bar;
}

// Stress reflected over stress arriving at the frequency omega.
std::complex<double> reflection(const std::vector<double>& history, const BarCase& bar, double omega) {
  const EndReflection end{(probe + 0.5) * bar.block_length, blocks * bar.block_length, speed, pulse, bar.stage.dt};
  const exact::ChainWave wave = exact::chain_wave(chain_of(bar), scheme_of(bar.stage.integrator), bar.stage.dt, omega);
  return end.of(history, omega, wave);
}

constexpr double omega = 2 * std::numbers::pi * 150;  // 29 blocks per wavelength
const double omega_length = omega / speed;            // of blocks 1 m long

struct End {
  std::string name;
  double stiffness, ratio;  // stiffness: N/m; ratio of a dashpot's impedance to that of the bar
  double reflected;         // of the stress
  std::string source;
};

void reflect(InterfaceLaw law, const End& end, Outcome& outcome) {
  BarCase bar = bar_with_end(law, dda::generalized_alpha_integrator(0.8), 2e-5);
  bar.end_stiffness = end.stiffness;
  bar.end_impedance = end.ratio * impedance(bar);
  const std::vector<double> engine = engine_histories(bar, outcome.counters)[0];
  const std::complex<double> measured = reflection(engine, bar, omega);
  const double eta = law == InterfaceLaw::classical ? bar.height / 20 : 0;
  outcome.assertions.push_back(
      expect(fmt::format("stress sent back at 150 Hz (error absolute, with its phase), {}, {}", end.name, name_of(law)),
             "")
          .is(measured.real())
          .against(end.reflected, end.source)
          .off_by(std::abs(measured - end.reflected))
          .within(eta / 2 + omega_length * omega_length / 12,
                  "the chain's own impedance is off by eta_s/2 (springs of 2 x 10 E: 1/40) and Omega^2/24"));
  const double difference = largest_difference(engine, closed_form_histories(bar)[0]);
  outcome.assertions.push_back(
      expect(fmt::format("largest difference from the closed form, of the peak, {}, {}", end.name, name_of(law)), "")
          .is(difference)
          .against(0, "finite chain with this end: inverse z-transform of its waves")
          .absolutely()
          .within(1e-9, "promised; the closed form is good to 1e-11"));
}

Outcome reflect(const std::vector<End>& ends) {
  Outcome outcome;
  for (const End& end : ends)
    for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic})
      reflect(law, end, outcome);
  return outcome;
}

Outcome fixed_and_free() { return reflect({{"fixed", 1e15, 0, 1, "+1"}, {"free", 0, 0, -1, "-1"}}); }

Outcome dashpots() {
  std::vector<End> ends;
  for (const double ratio : {0.0, 0.5, 1.0, 2.0})
    ends.push_back({fmt::format("a = {}", ratio), 0, ratio, exact::stress_reflection(ratio),
                    "(a - 1)/(a + 1), a the dashpot's impedance over the bar's"});
  return reflect(ends);
}

// A matched dashpot sends back |eta_s/4 + Omega^2/48 + i theta/8|, the last for Eq. 5 alone.
Outcome matched_dashpot() {
  Outcome outcome;
  for (const bool thesis : {true, false}) {
    for (const double spring : {10.0, 40.0}) {
      const double dt = 4e-5;
      BarCase bar =
          bar_with_end(InterfaceLaw::classical, thesis ? dda::thesis_integrator() : dda::trapezoidal_integrator(), dt);
      bar.joint.spring_over_young = spring;
      bar.end_impedance = impedance(bar);
      const double eta = bar.height / (2 * spring);
      const double theta = thesis ? omega * dt : 0;
      const double predicted = std::abs(std::complex<double>(eta / 4 + omega_length * omega_length / 48, theta / 8));
      const double measured = std::abs(reflection(engine_histories(bar, outcome.counters)[0], bar, omega));
      outcome.assertions.push_back(
          expect(fmt::format("part of the stress sent back at 150 Hz, {}, springs of {} E", bar.stage.integrator.name,
                             spring),
                 "")
              .is(measured)
              .against(predicted, thesis ? "abs(eta_s/4 + Omega^2/48 + i theta/8), to leading order"
                                         : "eta_s/4 + Omega^2/48, to leading order")
              .within(0.1, "left out: the square of each term, and of the half block at the end"));
    }
  }
  return outcome;
}

}  // namespace

std::vector<Case> bar_ends_cases() {
  return {
      {"bar-ends-fixed-free", "P wave at a fixed and at a free end of a bar", {34}, CaseLabel::fast, fixed_and_free},
      {"bar-ends-dashpot", "P wave at a dashpot at the end of a bar", {34}, CaseLabel::fast, dashpots},
      {"bar-ends-matched", "What a matched dashpot sends back", {34}, CaseLabel::fast, matched_dashpot}};
}

}  // namespace verify
