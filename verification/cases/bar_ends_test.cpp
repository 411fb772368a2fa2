// Catalogue 34: what comes back from the end of a bar - fixed, free, or on a dashpot of the ratio a to its impedance.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "verification/cases/bar_case.h"
#include "verification/exact/chain_modes.h"
#include "verification/exact/wave_speeds.h"

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

// Complex amplitude of a part of a history at the angular frequency omega.
std::complex<double> amplitude(const std::vector<double>& history, double dt, double omega, double from, double to) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    if (t >= from && t < to) sum += history[i] * std::polar(dt, -omega * t);
  }
  return sum;
}

struct Passages {
  double arrival, separation, end;  // s: the pulse comes to the probe, is past it, has come back past it
};

Passages passages() {
  const double there = (probe + 0.5) / speed;
  const double back = there + 2 * (blocks - probe - 0.5) / speed;
  return {there - 0.2 * pulse, (there + back + pulse) / 2, back + 1.6 * pulse};
}

// Stress reflected over stress arriving at the frequency omega, measured at the probe and led back to the end with the
// speed and attenuation of the chain's own waves.
std::complex<double> measured_reflection(const BarCase& bar, double omega) {
  const std::vector<double> history = engine_histories(bar)[0];
  const Passages at = passages();
  const double dt = bar.stage.dt;
  const std::complex<double> ratio =
      amplitude(history, dt, omega, at.separation, at.end) / amplitude(history, dt, omega, 0, at.separation);
  const exact::ChainWave wave = exact::chain_wave(chain_of(bar), scheme_of(bar.stage.integrator), dt, omega);
  const double path = 2 * (blocks - probe - 0.5) * bar.block_length;
  return ratio * std::exp(std::complex<double>(wave.attenuation * path, omega / wave.speed * path));
}

constexpr double omega = 2 * std::numbers::pi * 150;  // 29 blocks per wavelength
const double omega_length = omega / speed;            // of blocks 1 m long

struct End {
  std::string name;
  double stiffness, ratio;  // stiffness: N/m; ratio of a dashpot's impedance to that of the bar
  double reflected;         // of the stress
};

class Catalogue34 : public testing::TestWithParam<End> {};
INSTANTIATE_TEST_SUITE_P(Ends, Catalogue34,
                         testing::Values(End{"fixed", 1e15, 0, 1}, End{"free", 0, 0, -1},
                                         End{"dashpot_0", 0, 0, exact::stress_reflection(0)},
                                         End{"dashpot_half", 0, 0.5, exact::stress_reflection(0.5)},
                                         End{"dashpot_1", 0, 1, exact::stress_reflection(1)},
                                         End{"dashpot_2", 0, 2, exact::stress_reflection(2)}),
                         [](const auto& each) { return each.param.name; });

TEST_P(Catalogue34, ReflectsItsShare) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    BarCase bar = bar_with_end(law, dda::generalized_alpha_integrator(0.8), 2e-5);
    bar.end_stiffness = GetParam().stiffness;
    bar.end_impedance = GetParam().ratio * impedance(bar);
    // The chain's own impedance is off by eta_s/2 (classical springs of 2 * 10 E: eta_s = 1/40) and by Omega^2/24.
    const double eta = law == InterfaceLaw::classical ? bar.height / 20 : 0;
    EXPECT_NEAR(std::abs(measured_reflection(bar, omega) - GetParam().reflected), 0,
                eta / 2 + omega_length * omega_length / 12)
        << "law " << static_cast<int>(law);
    EXPECT_LT(largest_difference(engine_histories(bar)[0], closed_form_histories(bar)[0]), 1e-9);
  }
}

// A matched dashpot sends back |eta_s/4 + Omega^2/48 + i theta/8|, the last for Eq. 5 alone.
TEST(Catalogue34Matched, SendsBackWhatTheDiscreteChainSays) {
  for (const bool thesis : {true, false}) {
    for (const double spring : {10.0, 40.0}) {
      const double dt = 4e-5;
      BarCase bar =
          bar_with_end(InterfaceLaw::classical, thesis ? dda::thesis_integrator() : dda::trapezoidal_integrator(), dt);
      bar.joint.spring_over_young = spring;
      bar.end_impedance = impedance(bar);
      const double eta = bar.height / (2 * spring);
      const double theta = thesis ? omega * dt : 0;
      const std::complex<double> predicted(eta / 4 + omega_length * omega_length / 48, theta / 8);
      const double measured = std::abs(measured_reflection(bar, omega));
      // To leading order: the square of each term, and of the half block at the end, is left out.
      EXPECT_NEAR(measured, std::abs(predicted), 0.1 * std::abs(predicted))
          << "thesis " << thesis << ", spring " << spring;
    }
  }
}

}  // namespace
}  // namespace verify
