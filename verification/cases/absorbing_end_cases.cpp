#include "verification/cases/absorbing_end_cases.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "engine/builder/scheme.h"
#include "verification/cases/bar_case.h"
#include "verification/cases/end_reflection.h"
#include "verification/cases/jointed_bar.h"
#include "verification/exact/finite_chain.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using Complex = std::complex<double>;

constexpr int blocks = 80;  // of 1 m
constexpr int probe = 55;
constexpr double omega_length = 2 * std::numbers::pi / 20;  // Omega: 20 blocks a wavelength

struct Scheme {
  std::string name;
  dda::Integrator integrator;
};

std::vector<Scheme> schemes() {
  return {{"Eq. 5", dda::thesis_integrator()},
          {"trapezoidal", dda::trapezoidal_integrator()},
          {"HHT 0.1", dda::hht_integrator(0.1)},
          {"generalized-alpha 0.8", dda::generalized_alpha_integrator(0.8)},
          {"generalized-alpha 0", dda::generalized_alpha_integrator(0)},
          {"energy conserving", dda::energy_conserving_integrator()}};
}

// A wave of speed c takes 10 steps through a block of 1 m, under Eq. 5 20 steps.
double step(const dda::Integrator& integrator, double speed) { return (integrator.gamma == 1 ? 0.05 : 0.1) / speed; }

// The engine's history of the probe, the same in closed form, and what of the stress came back at Omega.
struct Echo {
  std::vector<double> engine, closed_form;
  Complex reflection;
};

EndReflection path(double speed, double dt) { return {probe + 0.5, blocks, speed, 16 / speed, dt}; }

struct PushedBar {
  BarCase bar;
  EndReflection end;
  double omega = 0;
};

// With steps in which a wave passes `courant` blocks.
PushedBar pushed_bar(dda::InterfaceLaw law, const dda::Integrator& integrator, double courant, double ratio) {
  PushedBar pushed;
  BarCase& bar = pushed.bar;
  bar = bonded_bar(law, integrator, 1, 1);
  bar.rock.poisson = 0;
  const double speed = exact::bar_speed(bar.rock.young, bar.rock.density);
  bar.stage.dt = courant / speed;
  pushed.end = path(speed, bar.stage.dt);
  bar.steps = static_cast<int>(pushed.end.duration() / bar.stage.dt);
  bar.blocks = blocks;
  bar.push = smooth_push(1e6, pushed.end.pulse);
  bar.probes = {probe};
  bar.end_impedance = ratio * bar.rock.density * speed * bar.height;
  pushed.omega = omega_length * speed;
  return pushed;
}

Echo p_echo(dda::InterfaceLaw law, const dda::Integrator& integrator, double ratio, Outcome& outcome,
            double springs = 10) {
  PushedBar pushed = pushed_bar(law, integrator, step(integrator, 1), ratio);
  BarCase& bar = pushed.bar;
  bar.joint.spring_over_young = springs;
  const exact::ChainWave wave = exact::chain_wave(chain_of(bar), scheme_of(integrator), bar.stage.dt, pushed.omega);
  Echo echo{engine_histories(bar, outcome.counters)[0], closed_form_histories(bar)[0], {}};
  echo.reflection = pushed.end.of(echo.engine, pushed.omega, wave);
  return echo;
}

Echo s_echo(const dda::Integrator& integrator, double ratio, Outcome& outcome) {
  JointedBar bar{.kind = WaveKind::s, .blocks = blocks, .block_length = 1};
  bar.integrator = integrator;
  bar.dt = step(integrator, bar.speed());
  const EndReflection end = path(bar.speed(), bar.dt);
  bar.steps = static_cast<int>(end.duration() / bar.dt);
  bar.incident = smooth_push(1e6, end.pulse);
  bar.absorbing_start = false;
  bar.end_ratio = ratio;
  bar.probes = {probe};
  const exact::BlockChain chain = shear_chain_of(bar);
  const exact::TimeScheme scheme = scheme_of(integrator);
  std::vector<double> push;
  for (int i = 0; i <= bar.steps; ++i) push.push_back(-bar.incident(i * bar.dt));
  const double omega = omega_length * bar.speed();
  Echo echo{stress_histories(bar, outcome.counters)[0],
            exact::finite_chain_response(chain, scheme, bar.dt, push, {{exact::ChainQuantity::block_stress, probe}})[0],
            {}};
  echo.reflection = end.of(echo.engine, omega, exact::chain_wave(chain, scheme, bar.dt, omega));
  return echo;
}

// What a matched dashpot sends back, to leading order; eta_s: springs between the blocks, of which the end has none.
double sent_back(const dda::Integrator& integrator, double eta = 0) {
  const double theta = integrator.gamma == 1 ? omega_length * step(integrator, 1) : 0;
  return std::abs(Complex(omega_length * omega_length / 48, theta / 8 + omega_length * eta / 4));
}

const std::string leading_order = "abs(Omega^2/48 + i theta/8), theta for Eq. 5 only, to leading order";

struct ClosedForm {
  double tolerance;
  std::string reason;
};

template <typename EchoOf>
void assert_ratios(const std::string& what, const Scheme& scheme, const ClosedForm& closed_form, EchoOf echo_of,
                   Outcome& outcome) {
  double from_continuum = 0;
  double from_closed_form = 0;
  const double bound = sent_back(scheme.integrator);
  for (const double ratio : {0.0, 0.1, 0.3, 1.0, 3.0, 10.0}) {
    const Echo echo = echo_of(ratio);
    keep_largest(from_continuum, std::abs(echo.reflection - exact::stress_reflection(ratio)));
    keep_largest(from_closed_form, largest_difference(echo.engine, echo.closed_form));
    if (ratio != 1) continue;
    outcome.assertions.push_back(
        expect(fmt::format("|R| of a matched edge, {}, {} (its size is the error)", what, scheme.name), "-")
            .is(std::abs(echo.reflection))
            .against(bound, leading_order)
            .off_by(std::abs(echo.reflection))
            .within(5e-3, "promised at 20 blocks a wavelength"));
  }
  outcome.assertions.push_back(
      expect(fmt::format("largest error of R, a = 0 to 10, {}, {} (absolute, with its phase)", what, scheme.name), "-")
          .is(from_continuum)
          .against(0, "(a - 1)/(a + 1)")
          .absolutely()
          .within(1.1 * bound, leading_order + "; at other ratios less; a tenth for the next order"));
  outcome.assertions.push_back(
      expect(
          fmt::format("largest difference from the closed form, of the peak, a = 0 to 10, {}, {}", what, scheme.name),
          "-")
          .is(from_closed_form)
          .against(0, "finite chain with this end: inverse z-transform of its waves")
          .absolutely()
          .within(closed_form.tolerance, closed_form.reason));
}

Outcome p_wave(dda::InterfaceLaw law) {
  Outcome outcome;
  for (const Scheme& scheme : schemes())
    assert_ratios(
        fmt::format("P, {}", name_of(law)), scheme, {1e-9, "promised; the closed form is good to 1e-11"},
        [&](double ratio) { return p_echo(law, scheme.integrator, ratio, outcome); }, outcome);
  return outcome;
}

Outcome s_wave() {
  Outcome outcome;
  for (const Scheme& scheme : schemes())
    assert_ratios(
        "S", scheme, {1e-5, "blocks are held sideways by springs of 1e6 E, which give way by 1e-6 over 25 m of 1 m"},
        [&](double ratio) { return s_echo(scheme.integrator, ratio, outcome); }, outcome);
  return outcome;
}

// Springs between the blocks lower the impedance of the bar, and the edge must follow: with rho c alone it would send
// back eta_s/4 as well. The half spring that the last block lacks towards the edge is left, i Omega eta_s/4.
Outcome springs() {
  Outcome outcome;
  for (const double springs : {5.0, 10.0, 40.0}) {
    const double eta = BarCase{}.height / (2 * springs);
    for (const Scheme& scheme : schemes()) {
      const Echo echo =
          p_echo(dda::InterfaceLaw::classical, scheme.integrator, 1 / std::sqrt(1 + eta), outcome, springs);
      const double measured = std::abs(echo.reflection);
      const double predicted = sent_back(scheme.integrator, eta);
      outcome.assertions.push_back(
          expect(fmt::format("|R| of an edge of rho c/sqrt(1 + eta_s), springs of {} E, {}", springs, scheme.name), "-")
              .is(measured)
              .against(predicted, "abs(Omega^2/48 + i theta/8 + i Omega eta_s/4), to leading order")
              .within(0.1, "left out: products of these terms"));
    }
  }
  return outcome;
}

// |R| of a matched edge with the corrections that scenes have: dashpots do not follow the sharpened loads. There is no
// closed form of these chains, whose waves are led to the end as those of the continuum.
double sent_back_corrected(dda::InterfaceLaw law, double courant, Outcome& outcome) {
  const dda::Stage preset = dda::preset_stage({}, dda::Kinematics::small, true);
  PushedBar pushed = pushed_bar(law, preset.integrator, courant, 1);
  pushed.bar.stage.correct_block_dispersion = preset.correct_block_dispersion;
  pushed.bar.stage.correct_time_dispersion = preset.correct_time_dispersion;
  const std::vector<double> history = engine_histories(pushed.bar, outcome.counters)[0];
  return std::abs(pushed.end.of(history, pushed.omega, {pushed.end.speed, 0}));
}

Outcome corrected() {
  Outcome outcome;
  for (const dda::InterfaceLaw law : {dda::InterfaceLaw::consistent, dda::InterfaceLaw::cubic})
    for (const double courant : {0.25, 0.5, 1.0}) {
      const double measured = sent_back_corrected(law, courant, outcome);
      outcome.assertions.push_back(
          expect(fmt::format("|R| of a matched edge, {} and corrected, c dt = {} block lengths (its size is the error)",
                             name_of(law), courant),
                 "-")
              .is(measured)
              .against(0, "a matched edge of the continuum")
              .absolutely()
              .within(5e-3, "promised at 20 blocks a wavelength"));
    }
  return outcome;
}

}  // namespace

std::vector<Case> absorbing_end_cases() {
  const auto p_of = [](dda::InterfaceLaw law) { return [=] { return p_wave(law); }; };
  return {
      {"absorbing-end-p",
       "P pulses at viscous edges, every integrator, consistent law",
       {34},
       CaseLabel::slow,
       p_of(dda::InterfaceLaw::consistent)},
      {"absorbing-end-p-cubic",
       "P pulses at viscous edges, every integrator, cubic law",
       {34},
       CaseLabel::slow,
       p_of(dda::InterfaceLaw::cubic)},
      {"absorbing-end-s", "S pulses at viscous edges, every integrator", {34}, CaseLabel::slow, s_wave},
      {"absorbing-end-springs",
       "P pulses at viscous edges matched to the springs between blocks",
       {34},
       CaseLabel::slow,
       springs},
      {"absorbing-end-corrected",
       "P pulses at viscous edges, as scenes have them that leave everything unsaid",
       {34},
       CaseLabel::fast,
       corrected},
  };
}

}  // namespace verify
