#include "verification/cases/joint_wave_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>

#include "verification/cases/bar_case.h"
#include "verification/cases/jointed_bar.h"
#include "verification/exact/joint_waves.h"
#include "verification/exact/signal.h"
#include "verification/harness/histories.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double pulse = 8e-3;  // s

std::string name_of(WaveKind kind) { return kind == WaveKind::p ? "P" : "S"; }

// ---- 33: an S wave travels at c_S.

// Delay between the probes of two bars' worth of way by cross-correlation, and the amplitude that is left.
struct Travel {
  double speed_error = 0;
  double amplitude_error = 0;
};

Travel travel(double block_length, double dt_share, Outcome& outcome) {
  JointedBar bar{.kind = WaveKind::s, .block_length = block_length};
  bar.blocks = static_cast<int>(std::lround(80 / block_length));
  bar.dt = dt_share * block_length / bar.speed();
  bar.incident = smooth_push(1e6, pulse);
  bar.steps = static_cast<int>(0.035 / bar.dt);
  const int first = static_cast<int>(10 / block_length);
  const int second = static_cast<int>(60 / block_length);
  bar.probes = {first, second};
  const auto histories = stress_histories(bar, outcome.counters);
  const exact::Signal near{histories[0], bar.dt};
  const exact::Signal far{histories[1], bar.dt};
  const double expected = (second - first) * block_length / bar.speed();
  const double lag = exact::correlation_lag(far, near, 0.9 * expected, 1.1 * expected).lag;
  const double peak = *std::max_element(histories[1].begin(), histories[1].end());
  return {expected / lag - 1, peak / 1e6 - 1};
}

Outcome s_wave_speed() {
  Outcome outcome;
  const double speed = JointedBar{.kind = WaveKind::s}.speed();
  const std::string source = "sqrt(E/(2 (1 + nu) rho))";
  const auto group_error = [&](double length) { return std::pow(two_pi / pulse * length / speed, 2) / 8; };
  const Travel coarse = travel(1, 0.1, outcome);
  const Travel fine = travel(0.5, 0.1, outcome);
  outcome.assertions.push_back(
      expect("speed of an S pulse over 50 m, blocks of 1 m", "m/s")
          .is(speed * (1 + coarse.speed_error))
          .against(speed, source)
          .off_by(coarse.speed_error)
          .within(group_error(1), "Omega^2/8, the group speed's error at 1/pulse: most of the pulse is slower"));
  outcome.assertions.push_back(expect("speed of an S pulse over 50 m, blocks of 0.5 m", "m/s")
                                   .is(speed * (1 + fine.speed_error))
                                   .against(speed, source)
                                   .off_by(fine.speed_error)
                                   .of_order({order(coarse.speed_error, fine.speed_error), 2, 0.1})
                                   .within(group_error(0.5), "Omega^2/8"));
  outcome.assertions.push_back(expect("peak of the S pulse after 60 m, blocks of 0.5 m", "Pa")
                                   .is(1e6 * (1 + fine.amplitude_error))
                                   .against(1e6, "no loss on the way")
                                   .off_by(fine.amplitude_error)
                                   .within(5e-3, "dispersion spreads the pulse; measured with margin"));
  return outcome;
}

// ---- 36, 37: joints as springs.

// T of `joints` joints 5 m apart at some frequencies: spectrum behind them over that of a bar without.
Outcome linear_joints(WaveKind kind, int joints) {
  constexpr double spacing = 5;       // m
  constexpr double half_power = 100;  // Hz: half of the energy passes one joint
  const double length = joints > 1 ? 0.25 : 0.5;
  const auto blocks_in = [&](double metres) { return static_cast<int>(std::lround(metres / length)); };
  JointedBar bar{.kind = kind, .blocks = blocks_in(120), .block_length = length, .dt = 4e-5};
  bar.incident = smooth_push(1e6, pulse);
  bar.steps = static_cast<int>(0.2 / bar.dt);  // what rings between the joints is gone by then
  bar.probes = {blocks_in(55 + joints * spacing)};
  Outcome outcome;
  const std::vector<double> reference = stress_histories(bar, outcome.counters)[0];
  const double stiffness = two_pi * half_power * bar.impedance() / 2;  // Pa/m
  // Springs at both corners of 1 m; the direction that should not move gets stiff ones.
  bar.special.law = dda::InterfaceLaw::classical;
  bar.special.bonded = true;
  bar.special.normal_spring = stiffness / 2 * (kind == WaveKind::p ? 1 : 1e3);
  bar.special.shear_to_normal = kind == WaveKind::p ? 1 : 1e-3;
  for (int i = 0; i < joints; ++i) bar.special_at.push_back(blocks_in(50 + i * spacing) - 1);
  const std::vector<double> passed = stress_histories(bar, outcome.counters)[0];
  for (const double frequency : {25.0, 50.0, 100.0, 150.0}) {
    const double omega = two_pi * frequency;
    const auto ratio = exact::fourier(passed, bar.dt, omega) / exact::fourier(reference, bar.dt, omega);
    // The bar without joints has the delay of the way between the joints as well.
    const auto expected = exact::joints_transmission(omega, bar.impedance(), stiffness, joints, spacing, bar.speed()) *
                          std::polar(1.0, omega * (joints - 1) * spacing / bar.speed());
    outcome.assertions.push_back(
        expect(fmt::format("|T| of {} joint{}, {} wave, {} Hz (error of the incident wave, with its phase)", joints,
                           joints > 1 ? "s" : "", name_of(kind), frequency),
               "-")
            .is(std::abs(ratio))
            .against(std::abs(expected), joints > 1 ? "transfer matrices (Cai & Zhao 2000)"
                                                    : "1/sqrt(1 + (omega Z/(2 k))^2) (Pyrak-Nolte 1990)")
            .off_by(std::abs(ratio - expected))
            .within(2e-3,
                    "1e-2 promised; blocks shorten the way between joints by Omega^2/24 of it, times the joints' "
                    "resonance"));
  }
  return outcome;
}

// ---- 38: a joint that slips.

double mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

// Stress at a block before and one behind the middle, in whole periods of the steady state.
struct Periods {
  std::vector<double> before, behind;
};

constexpr double slip_frequency = 100;

Periods steady_periods(JointedBar bar, double friction, Outcome& outcome) {
  constexpr int steps_in_period = 500;
  bar.dt = 1 / (slip_frequency * steps_in_period);
  bar.steps = 14 * steps_in_period;
  bar.incident = [](double t) {
    return 1e6 * std::sin(two_pi * slip_frequency * t) * std::min(1.0, t * slip_frequency / 2);
  };
  bar.initial_pressure = 1e6;
  bar.special.friction_angle = std::atan(friction);
  bar.special_at = {bar.blocks / 2 - 1};
  bar.probes = {bar.blocks / 2 - 4, bar.blocks / 2 + 3};
  const auto histories = stress_histories(bar, outcome.counters);
  const auto last = [&](const std::vector<double>& history) {
    return std::vector<double>(history.end() - 4 * steps_in_period, history.end());
  };
  return {last(histories[0]), last(histories[1])};
}

Outcome slip_joint() {
  Outcome outcome;
  const JointedBar bar{.kind = WaveKind::s, .blocks = 160};
  const Periods stuck = steady_periods(bar, 5, outcome);
  const double incident = mean_square(stuck.before);
  for (const double strength : {0.2, 0.5, 0.8}) {
    const Periods sliding = steady_periods(bar, strength, outcome);
    std::vector<double> sent_back = sliding.before;
    for (std::size_t i = 0; i < sent_back.size(); ++i) sent_back[i] -= stuck.before[i];
    const double transmitted = std::sqrt(mean_square(sliding.behind) / incident);
    const double reflected = std::sqrt(mean_square(sent_back) / incident);
    const double absorbed = std::sqrt(1 - transmitted * transmitted - reflected * reflected);
    const exact::SlipJointEnergies exact = exact::slip_joint(strength);
    const auto assert_share = [&](const std::string& what, double value, double expected) {
      outcome.assertions.push_back(expect(fmt::format("{}, strength {} of the wave", what, strength), "-")
                                       .is(value)
                                       .against(expected, "incident stress clipped at the strength (Miller 1978)")
                                       .within(1e-2, "promised; 54 blocks a wavelength, blocks keep no sharp corners"));
    };
    assert_share("root of the energy transmitted", transmitted, exact.transmitted);
    assert_share("root of the energy reflected", reflected, exact.reflected);
    assert_share("root of the energy absorbed by sliding", absorbed, exact.absorbed);
  }
  return outcome;
}

}  // namespace

std::vector<Case> joint_wave_cases() {
  const auto joints = [](WaveKind kind, int number) { return [=] { return linear_joints(kind, number); }; };
  return {
      {"s-bar", "An S pulse along a bar held sideways", {33}, CaseLabel::fast, s_wave_speed},
      {"linear-joint-p", "A P pulse through one joint", {36}, CaseLabel::fast, joints(WaveKind::p, 1)},
      {"linear-joint-s", "An S pulse through one joint", {36}, CaseLabel::fast, joints(WaveKind::s, 1)},
      {"parallel-joints-p", "A P pulse through three joints", {37}, CaseLabel::fast, joints(WaveKind::p, 3)},
      {"parallel-joints-s", "An S pulse through three joints", {37}, CaseLabel::fast, joints(WaveKind::s, 3)},
      {"slip-joint", "A harmonic S wave on a joint that slips", {38}, CaseLabel::slow, slip_joint},
  };
}

}  // namespace verify
