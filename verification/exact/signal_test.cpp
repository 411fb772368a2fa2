#include "verification/exact/signal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "verification/exact/bar_stress.h"

namespace exact {
namespace {

template <typename F>
std::vector<double> sample(const F& f, double interval, int count, double start = 0) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(f(start + i * interval));
  return values;
}

double wavelet(double t) { return std::exp(-t * t) * std::cos(2 * t); }
double wavelet_slope(double t) { return -std::exp(-t * t) * (2 * t * std::cos(2 * t) + 2 * std::sin(2 * t)); }

TEST(Signal, WindowKeepsItsEndsDespiteRoundOff) {
  const std::vector<double> values = sample([](double t) { return t; }, 0.1, 11);
  const Signal part = window({values, 0.1}, 0.3, 0.7);
  EXPECT_EQ(part.values.size(), 5U);
  EXPECT_DOUBLE_EQ(part.start, 0.30000000000000004);
  EXPECT_THROW((void)window({values, 0.1}, 2.0, 3.0), std::invalid_argument);
  EXPECT_THROW((void)window({values, 0.1}, 0.31, 0.39), std::invalid_argument);
}

TEST(Signal, HalfRangeSeesOnlyItsWindow) {
  const std::vector<double> values{9, 1, -3, 2, -7};
  EXPECT_DOUBLE_EQ(half_range({values, 1.0}, 1.0, 3.0), 2.5);
}

TEST(Signal, FirstPeakIsExactOnAParabolaAndSkipsSmallOnes) {
  const auto bump = [](double t) { return 3 - (t - 4.3) * (t - 4.3); };
  std::vector<double> values = sample([&](double t) { return std::max(bump(t), 0.0); }, 1.0, 20);
  values[1] = 0.5;   // a precursor below the fraction
  values[12] = 2.5;  // a later peak
  const Peak peak = first_peak({values, 0.5, 10.0}, Polarity::positive);
  EXPECT_NEAR(peak.time, 10 + 0.5 * 4.3, 1e-14);  // round-off
  EXPECT_NEAR(peak.value, 3.0, 1e-14);
  EXPECT_DOUBLE_EQ(first_peak({values, 0.5, 10.0}, Polarity::positive, 0.1).value, 0.5);
  EXPECT_THROW((void)first_peak({values, 0.5}, Polarity::negative), std::invalid_argument);
}

TEST(Signal, FirstPeakErrorFallsWithThirdOrderOrBetter) {
  const auto error = [](double interval) {
    const auto f = [](double t) { return std::sin(t) * std::exp(0.3 * t); };
    const double exact_time = std::numbers::pi - std::atan(1 / 0.3);
    const auto values = sample(f, interval, static_cast<int>(4 / interval), 0.123 * interval);
    return std::abs(first_peak({values, interval, 0.123 * interval}, Polarity::positive).time - exact_time);
  };
  // Third derivative over second, times interval^2/6 at worst: the ratio is near 0.5 here.
  for (const double interval : {0.1, 0.05, 0.025}) EXPECT_LT(error(interval), 0.1 * interval * interval);
}

TEST(Signal, OnsetIsTheLastSignChangeBeforeTheFirstPeak) {
  //                               0  1     2    3     4   5    6   7  8
  const std::vector<double> values{0, -0.1, 0.2, 0.1, -3, -10, -4, 2, -9};
  EXPECT_NEAR(onset({values, 2.0, 1.0}, Polarity::negative), 1.0 + 2.0 * (3 + 0.1 / 3.1), 1e-14);
  const std::vector<double> quiet_first{0, 0, 0, 1, 2, 1};
  EXPECT_DOUBLE_EQ(onset({quiet_first, 1.0}, Polarity::positive), 2.0);
  const std::vector<double> never_quiet{1, 2, 1};
  EXPECT_THROW((void)onset({never_quiet, 1.0}, Polarity::positive), std::invalid_argument);
}

TEST(Signal, InterpolationIsExactForFifthDegree) {
  const auto f = [](double t) { return 1 + t * (2 - t * (1 + t * (0.5 - t * (0.25 + 0.1 * t)))); };
  const std::vector<double> values = sample(f, 0.25, 12, -1.0);
  const Signal signal{values, 0.25, -1.0};
  for (const double t : {-1.0, -0.9, 0.11, 0.5, 1.6, 1.75}) EXPECT_NEAR(interpolate(signal, t), f(t), 1e-13) << t;
  EXPECT_EQ(interpolate(signal, 1.8), 0.0);
}

TEST(Signal, LagIsExactAgainstAContinuousReference) {
  for (const double delay : {0.0, 0.3, 1.2345, 3.0001}) {
    const double interval = 0.2;
    const auto values = sample([&](double t) { return -2.5 * wavelet(t - delay); }, interval, 80, -5);
    const auto found = correlation_lag(
        {values, interval, -5}, [](double t) { return -wavelet(t); }, -1, 4);
    EXPECT_NEAR(found.lag, delay, 1e-7);  // sqrt(eps): the correlation is flat at its top
    EXPECT_NEAR(found.coefficient, 1.0, 1e-14);
  }
}

TEST(Signal, LagOfOnePulseOfTheBarIsExactDespiteItsKinks) {
  const SinePulse pulse;
  const double dt = 1e-4, delay = 0.0115117;
  const auto reference = [&](double t) { return exact_bar_stress(pulse, t, 0, 4343.7, 1); };
  const auto values = sample([&](double t) { return reference(t - delay); }, dt, 400);
  EXPECT_NEAR(correlation_lag({values, dt}, reference, 0.005, 0.02).lag, delay, 1e-5 * dt);
}

// The end of a cycle, a kink, passes a sample that stands out: the coefficient has a summit on either side of that lag,
// and which is higher depends on the delay. No lag of a dense row may be better.
TEST(Signal, LagIsThatOfTheHighestOfSeveralSummits) {
  const SinePulse pulse;
  const double dt = 3.75e-4;
  const auto reference = [&](double t) { return exact_bar_stress(pulse, t, 0, 4343.7, 1); };
  for (double delay = 30.2 * dt; delay < 30.4 * dt; delay += 0.01 * dt) {
    auto values = sample([&](double t) { return reference(t - delay); }, dt, 80);
    values[57] += 0.4 * pulse.amplitude;  // tension; the cycle ends at 26.7 dt after the delay
    double best = 0;
    for (double lag = 28 * dt; lag < 32 * dt; lag += dt / 500) {
      double product = 0, energy = 0, square = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = reference(static_cast<double>(i) * dt - lag);
        product += values[i] * expected;
        energy += expected * expected;
        square += values[i] * values[i];
      }
      best = std::max(best, product / std::sqrt(energy * square));
    }
    for (double first = 26; first < 27; first += 0.1) {
      const auto found = correlation_lag({values, dt}, reference, first * dt, (first + 7.5) * dt);
      EXPECT_GE(found.coefficient, best - 1e-9) << delay / dt << " " << first;
    }
  }
}

TEST(Signal, LagBetweenTwoSampledSignalsIsBelowAThousandthOfAnInterval) {
  const double interval = 0.1, delay = 0.7431;
  const auto values = sample([&](double t) { return wavelet(t - delay); }, interval, 160, -6);
  const auto reference = sample(wavelet, interval, 120, -6.03);
  const auto found = correlation_lag({values, interval, -6}, {reference, interval, -6.03}, 0, 2);
  EXPECT_NEAR(found.lag, delay, 1e-3 * interval);
}

TEST(Signal, LagUnderNoiseStaysWithinTheCramerRaoBound) {
  const double interval = 0.05, delay = 0.7431, noise = 0.02;
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0, noise);
  const auto values = sample([&](double t) { return wavelet(t - delay) + normal(generator); }, interval, 250, -6);
  double slope_energy = 0;
  for (int i = 0; i < 250; ++i) slope_energy += std::pow(wavelet_slope(-6 + i * interval - delay), 2);
  const double deviation = noise / std::sqrt(slope_energy);  // of the best unbiased estimate
  const auto found = correlation_lag({values, interval, -6}, wavelet, 0, 2);
  EXPECT_NEAR(found.lag, delay, 4 * deviation);
  EXPECT_NE(found.lag, delay);
}

TEST(Signal, LagOfSilenceIsAnError) {
  const std::vector<double> values(50, 0.0);
  EXPECT_THROW((void)correlation_lag({values, 0.1}, wavelet, 0, 1), std::invalid_argument);
}

TEST(BarStress, PulseTravelsAtTheGivenSpeed) {
  const SinePulse pulse{.amplitude = 2e6, .frequency = 50};
  EXPECT_DOUBLE_EQ(pulse_force(pulse, 0.005), 2e6);
  EXPECT_EQ(pulse_force(pulse, 0.0201), 0);
  EXPECT_EQ(pulse_force(pulse, -1e-9), 0);
  EXPECT_DOUBLE_EQ(exact_bar_stress(pulse, 0.5 + 0.005, 2000, 4000, 4.0), -5e5);  // compression is negative
}

}  // namespace
}  // namespace exact
