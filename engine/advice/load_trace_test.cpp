#include "engine/advice/load_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dda {
namespace {

constexpr double interval = 1e-4;

double tone(double t) {
  if (t <= 0 || t >= 0.04) return 0;
  return std::pow(std::sin(std::numbers::pi * t / 0.04), 2) * std::sin(2 * std::numbers::pi * 100 * t);
}

std::vector<double> load(int samples) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) values.push_back(tone(i * interval));
  return values;
}

// Even sizes of small factors are at most a tenth apart from 100 on.
TEST(LoadTrace, TransformsAreOfSizesWithSmallFactors) {
  for (const std::size_t least : {2UL, 4098UL, 8002UL, 32762UL, 39998UL}) {
    std::size_t size = transform_size(least);
    EXPECT_GE(size, least);
    EXPECT_LE(static_cast<double>(size), 1.1 * static_cast<double>(least));
    EXPECT_EQ(size % 2, 0U);
    for (const std::size_t factor : {2UL, 3UL, 5UL})
      while (size % factor == 0) size /= factor;
    EXPECT_EQ(size, 1U) << least;
  }
}

TEST(LoadTrace, ADelayIsADelay) {
  for (const int samples : {799, 800}) {
    const LoadSpectrum spectrum(load(samples), interval);
    const double delay = 0.01234;
    const std::vector<double> trace = spectrum.through([&](Complex s) { return std::exp(-s * delay); });
    ASSERT_EQ(trace.size(), static_cast<std::size_t>(samples));
    // What is left out, frequencies of a share below 3e-5, grows a hundredfold towards the end of the window.
    for (int i = 0; i < samples; ++i)
      EXPECT_NEAR(trace[static_cast<std::size_t>(i)], tone(i * interval - delay), 1e-4) << i;
  }
}

// An oscillator goes on for ever; what it does after the window must not come round into it.
TEST(LoadTrace, WhatRingsOnDoesNotComeRound) {
  const double omega = 2 * std::numbers::pi * 100;
  std::vector<double> push(400, 0.0);
  push[0] = 1;
  const LoadSpectrum spectrum(push, interval);
  const std::vector<double> trace =
      spectrum.through([&](Complex s) { return omega * omega / (s * s + omega * omega); });
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const double wanted = omega * interval * std::sin(omega * interval * static_cast<double>(i));
    EXPECT_NEAR(trace[i], wanted, 0.02 * omega * interval)
        << i;  // a push of one sample has all frequencies, cut at 5 kHz
  }
}

TEST(LoadTrace, MainFrequency) { EXPECT_NEAR(LoadSpectrum(load(1000), interval).main_frequency(), 100, 5); }

TEST(TimeSteps, IsTheIntegratorsEquation) {
  for (const Integrator& integrator : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.2),
                                       generalized_alpha_integrator(0.8), generalized_alpha_integrator(0)}) {
    const double dt = 1e-3;
    const Complex s(30, 700);
    const Complex z = std::exp(s * dt);
    // A motion x = z^n, v, a from the two update rules; then (1 - am) a1 + am a0 = square ((1 - af) x1 + af x0).
    const Complex acceleration = 1.0 / (dt * dt *
                                        (((1 - integrator.gamma) + integrator.gamma * z) / ((z - 1.0) * (z - 1.0)) +
                                         (0.5 - integrator.beta + integrator.beta * z) / (z - 1.0)));
    const Complex wanted = acceleration * ((1 - integrator.alpha_m) * z + integrator.alpha_m) /
                           ((1 - integrator.alpha_f) * z + integrator.alpha_f);
    EXPECT_LT(std::abs(stepped_square(integrator, dt, s) / wanted - 1.0), 1e-12) << integrator.name;
  }
}

// A step leaves the share k of velocities at its end: v1 = k (v0 + ...) in the update rule.
TEST(TimeSteps, VelocitiesThatAreCutAreInTheEquation) {
  const double dt = 1e-3;
  const Complex s(30, 700);
  const Complex z = std::exp(s * dt);
  for (const Integrator& integrator : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.2)}) {
    for (const double kept : {0.999, 0.9}) {
      const Complex velocity = kept * dt * ((1 - integrator.gamma) + integrator.gamma * z) / (z - kept);  // over a
      const Complex place = (dt * velocity + dt * dt * (0.5 - integrator.beta + integrator.beta * z)) / (z - 1.0);
      const Complex wanted = ((1 - integrator.alpha_m) * z + integrator.alpha_m) /
                             ((1 - integrator.alpha_f) * z + integrator.alpha_f) / place;
      EXPECT_LT(std::abs(stepped_square(integrator, dt, s, kept) / wanted - 1.0), 1e-12) << integrator.name << kept;
    }
  }
}

TEST(TimeSteps, WithoutThemTimeIsContinuous) { EXPECT_EQ(TimeSteps{}.square({3, 4}), Complex(3, 4) * Complex(3, 4)); }

}  // namespace
}  // namespace dda
