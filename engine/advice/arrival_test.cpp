#include "engine/advice/arrival.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dda {
namespace {

constexpr double period = 0.01;
constexpr double on_time = 0.02;
constexpr double interval = 1e-4;

// One sine cycle from `on_time` on.
double cycle(double t) {
  const double phase = (t - on_time) / period;
  return phase <= 0 || phase >= 1 ? 0 : std::sin(2 * std::numbers::pi * phase);
}

std::vector<double> sampled(const std::function<double(double)>& function) {
  std::vector<double> samples;
  for (int i = 0; i < 700; ++i) samples.push_back(function(i * interval));
  return samples;
}

TEST(Arrival, AWaveThatIsLateAndWeak) {
  for (const double lag : {3.3e-4, -7.1e-4}) {
    const auto errors =
        read_arrival(sampled([&](double t) { return 0.9 * cycle(t - lag); }), interval, cycle, on_time, period);
    ASSERT_TRUE(errors.has_value());
    const double due = on_time / (on_time + lag) - 1;
    EXPECT_NEAR(errors->speed, due, 1e-7);
    EXPECT_NEAR(errors->amplitude, -0.1, 1e-7);
    EXPECT_NEAR(errors->peak, -0.1, 1e-5);  // parabolas through a sine of 100 samples: fourth order, 4e-6
    EXPECT_NEAR(errors->peak_speed, due, 1e-5);
    EXPECT_NEAR(errors->onset_speed, due, 1e-4);  // straight lines through a kink
  }
}

// A swing of the other sign before the wave moves neither its first peak nor its onset.
TEST(Arrival, TheFirstPeakOfItsSign) {
  const auto ringing = [](double t) {
    const double before = (t - on_time + 0.004) / 0.004;
    return cycle(t) - (before > 0 && before < 1 ? 0.7 * std::sin(std::numbers::pi * before) : 0);
  };
  const auto errors = read_arrival(sampled(ringing), interval, cycle, on_time, period);
  ASSERT_TRUE(errors.has_value());
  EXPECT_NEAR(errors->peak, 0, 1e-5);
  EXPECT_NEAR(errors->peak_speed, 0, 1e-5);
  EXPECT_NEAR(errors->onset_speed, 0, 1e-3);
}

// A rise that stays and a flat top say nothing of when they are highest.
TEST(Arrival, WhatStaysAtItsPeakHasNoneToRead) {
  const auto has_peak = [](const std::function<double(double)>& wave) {
    const auto errors = read_arrival(sampled(wave), interval, wave, on_time, period);
    return errors && errors->has_peak;
  };
  const auto rising = [](double until_top, double top) {
    return [=](double t) {
      const double phase = (t - on_time) / period;
      if (phase <= 0) return 0.0;
      return std::min({1.0, phase / until_top, std::max(0.0, (until_top + top - phase) / until_top + 1)});
    };
  };
  EXPECT_TRUE(has_peak(cycle));
  EXPECT_TRUE(has_peak(rising(0.3, 0)));
  EXPECT_TRUE(has_peak(rising(0.3, 0.05)));
  EXPECT_FALSE(has_peak(rising(0.3, 0.2)));
  EXPECT_FALSE(has_peak(rising(0.3, 100)));
}

// Half of the wave comes on time and all of it three periods later, which is what the best of all delays would find.
TEST(Arrival, AnotherPartCanBeMoreAlike) {
  const auto twice = [](double late) {
    return read_arrival(sampled([=](double t) { return 0.5 * cycle(t) + late * cycle(t - 0.03); }), interval, cycle,
                        on_time, period, {}, std::numeric_limits<double>::infinity(), OtherParts::compared);
  };
  ASSERT_TRUE(twice(1) && twice(0.2));
  EXPECT_GT(twice(1)->elsewhere, twice(1)->likeness);
  EXPECT_LT(twice(0.2)->elsewhere, twice(0.2)->likeness);
}

// What should come is a wave of one sign; where it is computed, round-off has swings of the other sign before it.
TEST(Arrival, RoundOffOfTheOtherSignIsNoPeak) {
  const auto hump = [](double t) {
    const double phase = (t - on_time) / period;
    return phase <= 0 || phase >= 1 ? 0 : std::pow(std::sin(std::numbers::pi * phase), 2);
  };
  const auto with_swings = [&](double size) {
    return [=](double t) { return hump(t) - (t < on_time ? size * std::pow(std::sin(t / 1e-3), 2) : 0); };
  };
  const auto errors = read_arrival(sampled([&](double t) { return 0.9 * with_swings(1e-3)(t - 3.3e-4); }), interval,
                                   with_swings(1e-6), on_time, period);
  ASSERT_TRUE(errors.has_value());
  const double due = on_time / (on_time + 3.3e-4) - 1;
  EXPECT_NEAR(errors->peak, -0.1, 1e-5);  // as for the sine cycle above
  EXPECT_NEAR(errors->peak_speed, due, 1e-5);
  EXPECT_NEAR(errors->onset_speed, due, 1e-4);
}

// A triangle whose summit lies between two samples: the exact wave has all of it, so what is read of the samples alone
// is its own loss. Without a trace that differs, the first peak is short by what the parabola through the samples
// misses.
TEST(Arrival, AKinkBetweenSamplesCountsInFull) {
  constexpr double coarse = 1e-3;
  const auto triangle = [](double t) { return std::max(0.0, 1 - std::abs(t - on_time - 4.4e-3) / 4e-3); };
  std::vector<double> trace;
  for (int i = 0; i < 40; ++i) trace.push_back(triangle(i * coarse));
  const auto errors = read_arrival(trace, coarse, triangle, on_time, period);
  ASSERT_TRUE(errors.has_value());
  EXPECT_NEAR(errors->amplitude, 0, 1e-9);
  // Samples 0.9, 0.85 and 0.65 beside the summit: -1/10 of the largest; the parabola through them 0.9 + 1/60.
  EXPECT_NEAR(errors->largest, -0.1, 1e-6);
  EXPECT_NEAR(errors->peak, 0.9 + 1.0 / 60 - 1, 1e-6);
}

// A record's first bump beyond half of its largest value is one thing, its largest value another.
TEST(Arrival, TheFirstPeakIsNotTheLargest) {
  const auto bump = [](double t, double at) {
    return std::abs(t - at) > 2e-3 ? 0 : std::pow(std::cos(std::numbers::pi * (t - at) / 4e-3), 2);
  };
  const auto wave = [&](double first, double second) {
    return [=](double t) { return first * bump(t, on_time + 3e-3) - second * bump(t, on_time + 8e-3); };
  };
  const auto errors = read_arrival(sampled(wave(0.4, 0.9)), interval, wave(0.7, 1), on_time, period);
  ASSERT_TRUE(errors.has_value());
  EXPECT_NEAR(errors->peak, 0.4 / 0.7 - 1, 1e-5);  // as for the sine cycle above
  EXPECT_NEAR(errors->largest, -0.1, 1e-9);
  const auto cut = read_arrival(sampled(wave(0.4, 0.9)), interval, wave(0.7, 1), on_time, period, {}, on_time + 5e-3);
  ASSERT_TRUE(cut.has_value());
  EXPECT_NEAR(cut->largest, 0.4 / 0.7 - 1, 1e-9);
  // A run that is over before the wave comes has no largest value of its own.
  const auto before = read_arrival(sampled(wave(0.4, 0.9)), interval, wave(0.7, 1), on_time, period, {}, on_time / 2);
  ASSERT_TRUE(before.has_value());
  EXPECT_EQ(before->largest, errors->largest);
}

TEST(Arrival, NothingWhereTheWaveIsHalfAPeriodOffItsTime) {
  EXPECT_FALSE(read_arrival(sampled([](double t) { return cycle(t - 0.006); }), interval, cycle, on_time, period));
  EXPECT_FALSE(read_arrival(std::vector<double>(500, 0.0), interval, cycle, on_time, period));
}

// With four samples in a period the coefficient has summits side by side; the larger counts.
TEST(Arrival, TheLargestOfSeveralSummits) {
  const double coarse = period / 4;
  std::vector<double> trace;
  for (int i = 0; i < 20; ++i) trace.push_back(cycle(i * coarse - 2e-4));
  const auto errors = read_arrival(trace, coarse, cycle, on_time, period);
  ASSERT_TRUE(errors.has_value());
  EXPECT_NEAR(errors->speed, on_time / (on_time + 2e-4) - 1, 1e-6);
}

}  // namespace
}  // namespace dda
