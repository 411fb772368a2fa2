#include "verification/cases/p_bar_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "verification/cases/bar_case.h"
#include "verification/exact/signal.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::InterfaceLaw;

std::vector<dda::Integrator> integrators() {
  return {dda::thesis_integrator(), dda::trapezoidal_integrator(), dda::hht_integrator(0.1),
          dda::generalized_alpha_integrator(0.8)};
}

const std::vector<InterfaceLaw> laws = {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic};

constexpr double pulse = 5e-3;  // s; sin^4 has lines at 1/pulse and 2/pulse

// ---- Against the closed form.

Assertion difference_from_closed_form(std::string given, double difference) {
  return expect("largest difference from the closed form, of the peak, " + std::move(given), "")
      .is(difference)
      .against(0, "finite chain under the same time scheme: inverse z-transform of its waves")
      .absolutely()
      .within(1e-9, "promised; the closed form is good to 1e-11");
}

// Long enough for the pulse to reach the free end and come back past the probes.
void compare_with_closed_form(InterfaceLaw law, const dda::Integrator& integrator, double dt, Outcome& outcome) {
  BarCase bar = bonded_bar(law, integrator, dt, static_cast<int>(0.03 / dt));
  bar.push = smooth_push(1e6, pulse);
  bar.probes = {0, 10, 38};
  const Histories engine = engine_histories(bar, outcome.counters);
  const Histories exact = closed_form_histories(bar);
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) keep_largest(largest, largest_difference(engine[i], exact[i]));
  outcome.assertions.push_back(
      difference_from_closed_form(fmt::format("{}, dt = {} ms", integrator.name, 1e3 * dt), largest));
}

Outcome closed_form(InterfaceLaw law) {
  Outcome outcome;
  for (const dda::Integrator& integrator : integrators())
    for (const double dt : {1e-5, 1e-4}) compare_with_closed_form(law, integrator, dt, outcome);
  return outcome;
}

double difference(const BarCase& bar, dda::Counters& counters) {
  return largest_difference(engine_histories(bar, counters)[0], closed_form_histories(bar)[0]);
}

Outcome plane_strain() {
  Outcome outcome;
  for (const InterfaceLaw law : laws) {
    BarCase bar = bonded_bar(law, dda::generalized_alpha_integrator(0.8), 5e-5, 400);
    bar.push = smooth_push(1e6, pulse);
    bar.rock.plane = dda::PlaneState::strain;
    bar.rock.poisson = 0.3;
    if (law != InterfaceLaw::cubic) bar.stage.strain_inertia = 2;
    outcome.assertions.push_back(difference_from_closed_form(name_of(law), difference(bar, outcome.counters)));
  }
  return outcome;
}

Outcome cubic_options() {
  Outcome outcome;
  for (const bool lateral : {false, true}) {
    for (const bool corrected : {false, true}) {
      BarCase bar = bonded_bar(InterfaceLaw::cubic, dda::generalized_alpha_integrator(0.8), 1e-4, 300);
      bar.push = smooth_push(1e6, pulse);
      bar.stage.lateral_inertia = lateral;
      bar.stage.correct_time_dispersion = corrected;
      outcome.assertions.push_back(difference_from_closed_form(
          fmt::format("lateral inertia {}, period correction {}", lateral ? "on" : "off", corrected ? "on" : "off"),
          difference(bar, outcome.counters)));
    }
  }
  return outcome;
}

// ---- Against the wave equation.

double time_step(double block_length) { return 0.2 * block_length / exact::bar_speed(50e9, 2650); }

// A bar without lateral contraction, recorded at a place until anything may come back from its end; dt falls with the
// block length.
struct Arrival {
  double dt;
  std::vector<double> engine, exact;  // Pa; of the engine and of the wave equation
};

Arrival arrival(InterfaceLaw law, const dda::Integrator& integrator, double block_length, bool corrected, double place,
                dda::Counters& counters) {
  const double speed = exact::bar_speed(50e9, 2650);
  const double dt = time_step(block_length);
  BarCase bar = bonded_bar(law, integrator, dt, static_cast<int>(std::lround(50 / (speed * dt))));
  bar.block_length = block_length;
  bar.blocks = static_cast<int>(std::lround(40 / block_length));
  bar.rock.poisson = 0;
  // Springs add the compliance L E/k to that of a block, so they must stiffen as 1/L^3 for an error of second order.
  bar.joint.spring_over_young = 100 / (block_length * block_length * block_length);
  bar.stage.correct_time_dispersion = corrected;
  bar.push = smooth_push(1e6, pulse);
  const int probe = static_cast<int>(place / block_length);
  const double x = (probe + 0.5) * block_length;
  bar.probes = {probe};
  Arrival result{dt, engine_histories(bar, counters)[0], {}};
  for (std::size_t i = 0; i < result.engine.size(); ++i)
    result.exact.push_back(-bar.push(static_cast<double>(i) * dt - x / speed) / bar.height);
  return result;
}

// Delay (s) of the engine's wave behind the exact one.
double delay(const Arrival& arrival) {
  const exact::Signal engine{arrival.engine, arrival.dt};
  const exact::Signal reference{arrival.exact, arrival.dt};
  return exact::correlation_lag(engine, reference, -2e-4, 2e-4).lag;
}

struct Convergence {
  InterfaceLaw law;
  dda::Integrator integrator;
  bool corrected;
  double order;
  double finest;  // allowed at blocks of 0.25 m
  std::string reason;
};

std::vector<Convergence> convergences() {
  const std::string second =
      "leading terms Omega^2/24 and theta^2/12 of the speed at the pulse's middle frequency, times "
      "its steepest slope: 1.7e-3";
  const dda::Integrator trapezoidal = dda::trapezoidal_integrator();
  return {{InterfaceLaw::consistent, trapezoidal, false, 2, 2e-3, second},
          {InterfaceLaw::consistent, dda::hht_integrator(0.1), false, 2, 2e-3, second},
          {InterfaceLaw::consistent, dda::generalized_alpha_integrator(0.8), false, 2, 2e-3, second},
          {InterfaceLaw::consistent, dda::thesis_integrator(), false, 1, 3e-2, "Eq. 5 damps by omega^2 dt t/4: 2.2e-2"},
          {InterfaceLaw::classical, trapezoidal, false, 2, 2e-3, second},
          {InterfaceLaw::cubic, trapezoidal, false, 2, 4e-4,
           "theta^2/12 alone: 8e-5, four times that at the upper end of the pulse's spectrum, 3.2e-4"},
          {InterfaceLaw::cubic, trapezoidal, true, 4, 8e-7,
           "the half block at the pushed end, of fourth order in strength; measured 5.9e-7"}};
}

Outcome wave_equation(const Convergence& given) {
  Outcome outcome;
  std::vector<double> errors;
  for (const double length : {0.5, 0.25}) {
    const Arrival wave = arrival(given.law, given.integrator, length, given.corrected, 20.5, outcome.counters);
    errors.push_back(largest_difference(wave.engine, wave.exact));
  }
  Assertion assertion =
      expect(fmt::format("largest difference, of the peak, blocks of 0.25 m, {}, {}{}", name_of(given.law),
                         given.integrator.name, given.corrected ? ", period corrected" : ""),
             "")
          .is(errors[1])
          .against(0, "f(t - x/c), c = sqrt(E/rho)")
          .absolutely()
          .within(given.finest, given.reason);
  assertion.order = Order{order(errors[0], errors[1]), given.order, 0.15};
  outcome.assertions = {assertion};
  return outcome;
}

Outcome wave_equation_orders() {
  Outcome all;
  for (const Convergence& given : convergences()) {
    const Outcome one = wave_equation(given);
    all.assertions.push_back(one.assertions.front());
    all.counters += one.counters;
  }
  return all;
}

// Delay (s) that the wave gathers between about 8 and 26 m; the end it came from plays no part in it.
double gathered_delay(double block_length, bool corrected, dda::Counters& counters) {
  const dda::Integrator integrator = dda::trapezoidal_integrator();
  return delay(arrival(InterfaceLaw::cubic, integrator, block_length, corrected, 26.5, counters)) -
         delay(arrival(InterfaceLaw::cubic, integrator, block_length, corrected, 8.5, counters));
}

// What the correction of the integrator's period is for: waves keep their speed to fourth order. (Blocks add an error
// of sixth order that takes part of it away, so that no order is seen.)
Outcome speed_of_cubic_chains() {
  Outcome outcome;
  const double travel_time = 18 / exact::bar_speed(50e9, 2650);
  const double theta = 2 * std::numbers::pi * (2 / pulse) * time_step(0.5);
  for (const bool corrected : {true, false}) {
    const double coarse = gathered_delay(1, corrected, outcome.counters);
    const double fine = gathered_delay(0.5, corrected, outcome.counters);
    const double of_time = fine / travel_time;
    Assertion assertion =
        expect(fmt::format("delay over 18 m, of the travel time, blocks of 0.5 m, period correction {}",
                           corrected ? "on" : "off"),
               "")
            .is(of_time)
            .against(0, "x/c, c = sqrt(E/rho)")
            .absolutely()
            .within(corrected ? std::pow(theta, 4) / 480 : theta * theta / 12,
                    fmt::format("{} at 2/duration of the pulse, the upper of its two lines",
                                corrected ? "theta^4/480 of the fourth-order rule" : "theta^2/12"));
    if (!corrected) assertion.order = Order{order(std::abs(coarse), std::abs(fine)), 2, 0.1};
    outcome.assertions.push_back(assertion);
  }
  return outcome;
}

}  // namespace

std::vector<Case> p_bar_cases() {
  std::vector<Case> cases;
  for (const InterfaceLaw law : laws)
    cases.push_back({"p-bar-chain-" + name_of(law),
                     "P wave along a bar of blocks against the closed form of its chain, " + name_of(law) + " law",
                     {32},
                     CaseLabel::fast,
                     [law] { return closed_form(law); }});
  cases.push_back({"p-bar-chain-plane-strain",
                   "P wave in plane strain, strains of double inertia under two of the laws",
                   {32},
                   CaseLabel::fast,
                   plane_strain});
  cases.push_back({"p-bar-chain-cubic-options",
                   "P wave under the cubic law with its options",
                   {32},
                   CaseLabel::fast,
                   cubic_options});
  cases.push_back({"p-bar-wave-equation",
                   "P wave along a bar against the wave equation",
                   {32},
                   CaseLabel::fast,
                   wave_equation_orders});
  cases.push_back(
      {"p-bar-speed-cubic", "Speed of P waves along cubic chains", {32}, CaseLabel::fast, speed_of_cubic_chains});
  return cases;
}

}  // namespace verify
