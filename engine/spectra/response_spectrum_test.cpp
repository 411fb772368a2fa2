// Oscillators on ground whose motion has an answer in closed form (e.g. Chopra, Dynamics of Structures, chapter 4).
#include "engine/spectra/response_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "engine/spectra/oscillator.h"

namespace dda {
namespace {

using std::numbers::pi;

constexpr double exact = 1e-10;  // of the answer: round-off of some thousand steps

MotionRecord sampled(GroundMotion kind, const std::function<double(double)>& motion, double duration, int intervals) {
  MotionRecord record{kind, {}, {}};
  for (int i = 0; i <= intervals; ++i) {
    record.times.push_back(duration * i / intervals);
    record.values.push_back(motion(record.times.back()));
  }
  return record;
}

// A step of acceleration swings by 1 + exp(-pi r/sqrt(1 - r^2)) of its static displacement, wherever samples lie; it is
// a ramp of velocity.
TEST(ResponseSpectrum, OfAStepIsExact) {
  const double a = 3;
  for (const double ratio : {0.0, 0.02, 0.05, 0.5, 0.9})
    for (const double period : {0.03, 0.1, 0.7})
      for (const int intervals : {7, 100, 3000}) {
        const double omega = 2 * pi / period;
        const double overshoot = 1 + std::exp(-pi * ratio / std::sqrt(1 - ratio * ratio));
        const double expected = a / (omega * omega) * overshoot;
        const double duration = 2 * period;  // the peak of weak damping is at half a period, of 0.9 at 1.15
        const MotionRecord step = sampled(
            GroundMotion::acceleration, [&](double) { return a; }, duration, intervals);
        EXPECT_NEAR(spectral_displacement(step, period, ratio), expected, exact * expected) << period << " " << ratio;
        const MotionRecord ramp = sampled(
            GroundMotion::velocity, [&](double t) { return 5 + a * t; }, duration, intervals);
        EXPECT_NEAR(spectral_displacement(ramp, period, ratio), expected, exact * expected) << period << " " << ratio;
      }
}

// Ground that moves off at a velocity V at once: u = -V exp(-r w t) sin(w_d t)/w_d.
TEST(ResponseSpectrum, OfGroundThatMovesOffIsExact) {
  for (const double ratio : {0.0, 0.05, 0.6}) {
    const double period = 0.4, omega = 2 * pi / period, speed = 2;
    const double damped = omega * std::sqrt(1 - ratio * ratio);
    const double when = std::acos(ratio) / damped;  // of the first maximum
    const double expected = speed * std::exp(-ratio * omega * when) * std::sin(damped * when) / damped;
    for (const int intervals : {9, 400}) {
      const MotionRecord record = sampled(
          GroundMotion::displacement, [&](double t) { return 1 + speed * t; }, 1, intervals);
      EXPECT_NEAR(spectral_displacement(record, period, ratio), expected, exact * expected) << intervals;
    }
  }
}

// Acceleration that rises over a time and then stays: 1 + |sin x|/x of the static displacement, x = pi rise/period.
TEST(ResponseSpectrum, OfARampIsExact) {
  const double a = 2, rise = 0.3;
  for (const double period : {0.11, 0.24, 0.4, 1.7}) {
    const double x = pi * rise / period;
    const double still = a * period * period / (4 * pi * pi);
    const double expected = still * (1 + std::abs(std::sin(x)) / x);
    MotionRecord record{GroundMotion::acceleration, {0, rise, rise + 0.13 * period, rise + 3 * period}, {0, a, a, a}};
    EXPECT_NEAR(spectral_displacement(record, period, 0), expected, exact * expected) << period;
  }
}

// u of an oscillator of no damping at the end of a ramp of acceleration c t: -c/w^2 (t - sin(w t)/w).
TEST(ResponseSpectrum, GrowsWithARampWithoutEnd) {
  const double c = 5;
  for (const double period : {0.01, 1.0, 300.0}) {
    const double omega = 2 * pi / period;
    const MotionRecord record = sampled(
        GroundMotion::acceleration, [&](double t) { return c * t; }, 1, 1000);
    double sum = 0, term = omega;  // of omega - sin(omega), by its series where it is small
    for (int n = 1; n < 40; ++n) sum -= term *= -omega * omega / ((2 * n) * (2 * n + 1));
    const double difference = omega < 1 ? sum : omega - std::sin(omega);
    const double expected = c * difference / (omega * omega * omega);
    EXPECT_NEAR(spectral_displacement(record, period, 0), expected, exact * expected) << period;
  }
}

// Under a half sine of acceleration and after it, without damping: from the closed form of the motion.
double peak_of_half_sine(double period, double pulse) {
  const double omega = 2 * pi / period, load = pi / pulse;
  const double scale = 1 / (omega * omega - load * load);
  const auto during = [&](double t) { return scale * (std::sin(load * t) - load / omega * std::sin(omega * t)); };
  const auto rate = [&](double t) { return scale * load * (std::cos(load * t) - std::cos(omega * t)); };
  double peak = std::hypot(during(pulse), rate(pulse) / omega);  // of the free vibration
  for (int n = 1; n < 50; ++n)                                   // where cos(load t) = cos(omega t)
    for (const double t : {2 * pi * n / (omega + load), 2 * pi * n / std::abs(omega - load)})
      if (t <= pulse) peak = std::max(peak, std::abs(during(t)));
  return peak;
}

// Curves are followed by straight lines, which is of second order in their length.
TEST(ResponseSpectrum, OfCurvesIsOfSecondOrder) {
  const double pulse = 0.2;
  const auto half_sine = [&](double t) { return t < pulse ? std::sin(pi * t / pulse) : 0; };
  for (const double period : {0.07, 0.15, 0.3, 1.1}) {
    const double expected = peak_of_half_sine(period, pulse);
    std::array<double, 2> errors{};
    for (const int finer : {1, 2}) {
      MotionRecord fine{GroundMotion::acceleration, {}, {}};
      const int in_pulse = 40 * finer;
      for (int i = 0; i <= in_pulse; ++i) {
        fine.times.push_back(pulse * i / in_pulse);
        fine.values.push_back(i == in_pulse ? 0 : half_sine(fine.times.back()));
      }
      fine.times.push_back(pulse + 2 * period);
      fine.values.push_back(0);
      errors[static_cast<std::size_t>(finer - 1)] = std::abs(spectral_displacement(fine, period, 0) / expected - 1);
    }
    EXPECT_LT(errors[1], 1e-3) << period;
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1) << period;
  }
}

// Ground that shakes as a sine, from rest: the oscillator's own vibration and the steady one, followed in time.
TEST(ResponseSpectrum, OfAShakenGroundIsOfSecondOrder) {
  const double ratio = 0.05, load = 2 * pi / 0.5, omega = 2 * pi / 0.31;
  const double damped = omega * std::sqrt(1 - ratio * ratio);
  const double c = omega * omega - load * load, d = 2 * ratio * omega * load;
  const double in_phase = -c / (c * c + d * d), out_of_phase = d / (c * c + d * d);  // sin and cos of the steady part
  const auto exact_motion = [&](double t) {
    const double own = -(load * in_phase + ratio * omega * out_of_phase) / damped;
    return in_phase * std::sin(load * t) + out_of_phase * std::cos(load * t) +
           std::exp(-ratio * omega * t) * (-out_of_phase * std::cos(damped * t) + own * std::sin(damped * t));
  };
  double expected = 0;
  for (int i = 0; i < 2'000'000; ++i) expected = std::max(expected, std::abs(exact_motion(3e-6 * i)));
  // The same motion of the ground as acceleration, velocity and displacement that begin from rest.
  const std::array motions = {std::function([&](double t) { return std::sin(load * t); }),
                              std::function([&](double t) { return (1 - std::cos(load * t)) / load; }),
                              std::function([&](double t) { return (t - std::sin(load * t) / load) / load; })};
  const std::array kinds = {GroundMotion::acceleration, GroundMotion::velocity, GroundMotion::displacement};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 2> errors{};
    for (const std::size_t finer : {1U, 2U})
      errors[finer - 1] =
          std::abs(spectral_displacement(sampled(kinds[k], motions[k], 6, static_cast<int>(600 * finer)), 0.31, ratio) /
                       expected -
                   1);
    EXPECT_LT(errors[1], 1e-3) << k;
    // How far a line is from the curve of displacements itself, up to dt^2/8 of the acceleration, depends on where the
    // peak lies between samples.
    if (kinds[k] == GroundMotion::displacement)
      EXPECT_LT(std::max(errors[0], 4 * errors[1]) * expected, 0.01 * 0.01 / 2);
    else
      EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.15) << k;
  }
}

// The largest displacement by the Runge-Kutta scheme with `parts` steps in every interval of a record of acceleration.
// Where the rate changes its sign within a step the parabola that begins with it says how far.
double largest_of_small_steps(const Oscillator& oscillator, const MotionRecord& record, int parts) {
  double u = 0, v = 0, largest = 0;
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    const double dt = (record.times[i] - record.times[i - 1]) / parts;
    for (int part = 0; part < parts; ++part) {
      const auto rate = [&](double w, double w_rate, double share) {
        const double force = record.values[i - 1] + (record.values[i] - record.values[i - 1]) * (part + share) / parts;
        return derivative(2, oscillator, {w, w_rate}, force, 0);
      };
      const double a1 = rate(u, v, 0);
      const double a2 = rate(u + dt / 2 * v, v + dt / 2 * a1, 0.5);
      const double a3 = rate(u + dt / 2 * v + dt * dt / 4 * a1, v + dt / 2 * a2, 0.5);
      const double a4 = rate(u + dt * v + dt * dt / 2 * a2, v + dt * a3, 1);
      const double v_before = v, at_top = u - v * v / (2 * a1);
      u += dt * v + dt * dt / 6 * (a1 + a2 + a3);
      v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      largest = std::max({largest, std::abs(u), v_before * v < 0 ? std::abs(at_top) : 0});
    }
  }
  return largest;
}

MotionRecord random_record(std::mt19937& random, int intervals, const std::function<double()>& interval) {
  std::uniform_real_distribution<double> number(-1, 1);
  MotionRecord record{GroundMotion::acceleration, {0}, {number(random)}};
  for (int i = 0; i < intervals; ++i) {
    record.times.push_back(record.times.back() + interval());
    record.values.push_back(number(random));
  }
  return record;
}

// Records drawn at random, beside many small steps.
TEST(ResponseSpectrum, OfRandomRecordsIsThatOfManySmallSteps) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const double period = std::pow(10, number(random));
    const Oscillator oscillator{2 * pi / period, std::abs(number(random)) * 0.95};
    const auto interval = [&] { return period * std::pow(10, -1 + 0.7 * number(random)); };
    const MotionRecord record = random_record(random, 20, interval);
    const double largest = largest_of_small_steps(oscillator, record, 2000);
    // What parabolas leave of peaks is of the third order in omega dt, 3e-3 in the longest intervals.
    EXPECT_NEAR(spectral_displacement(record, period, oscillator.ratio), largest, 1e-5 * largest) << seed;
  }
}

// Strong damping, and few rows as long as the oscillator turns in twice: a swing of which no row's ends know.
TEST(ResponseSpectrum, KnowsSwingsWithinOneRow) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const Oscillator oscillator{2 * pi, 0.3 + 0.65 * share(random)};
    const auto interval = [&] { return 0.02 + 0.3 * share(random); };
    const MotionRecord record = random_record(random, 3, interval);
    const double largest = largest_of_small_steps(oscillator, record, 500);
    // Likewise: 6e-8 of the third power of 4e-3.
    EXPECT_NEAR(spectral_displacement(record, 1, oscillator.ratio), largest, 1e-6 * largest) << seed;
  }
}

// What is soft stays where it is, what is stiff goes with the ground.
TEST(ResponseSpectrum, EndsWithTheGroundsOwnMotion) {
  const auto pulse = [](double t) { return std::sin(pi * t) * std::sin(pi * t); };
  const MotionRecord acceleration = sampled(GroundMotion::acceleration, pulse, 1, 2000);
  const double stiff = 2 * pi / 1e-3;
  EXPECT_NEAR(spectral_displacement(acceleration, 1e-3, 0.05) * stiff * stiff, 1, 1e-3);
  const MotionRecord displacement = sampled(GroundMotion::displacement, pulse, 1, 2000);
  EXPECT_NEAR(spectral_displacement(displacement, 1e4, 0.05), 1, 1e-3);
}

// Samples at the same time are a jump, and change nothing before or after it.
TEST(ResponseSpectrum, TakesJumps) {
  const MotionRecord step{GroundMotion::acceleration, {0, 1, 1, 2}, {0, 0, 3, 3}};
  const double still = 3 * 0.09 / (4 * pi * pi);
  EXPECT_NEAR(spectral_displacement(step, 0.3, 0), 2 * still, exact * still);
  EXPECT_EQ(spectral_displacement({GroundMotion::acceleration, {}, {}}, 0.3, 0.05), 0);
}

TEST(ResponseSpectrum, PeriodsThatARecordResolves) {
  const PeriodRange range = resolved_periods({1, 1.1, 1.3, 2, 4.9, 5});
  EXPECT_NEAR(range.shortest, 29, 1e-12);
  EXPECT_NEAR(range.longest, 4, 1e-12);
  const std::vector<double> periods = spaced_evenly_in_logarithm({0.01, 10}, 4);
  ASSERT_EQ(periods.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(periods[i], std::pow(10, -2 + static_cast<double>(i)), 1e-14 * periods[i]);
  EXPECT_EQ(periods.back(), 10);
}

}  // namespace
}  // namespace dda
