#include "verification/exact/cantilever.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exact {
namespace {

const Cantilever beam{8, 1, 1e9, 0.25, 2000};
constexpr double load = 1e3;

double integral(double from, double to, double (*f)(double)) {
  constexpr int parts = 200;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double a = from + (to - from) * i / parts;
    const double b = from + (to - from) * (i + 1) / parts;
    sum += (b - a) / 6 * (f(a) + 4 * f((a + b) / 2) + f(b));
  }
  return sum;
}

TEST(Cantilever, StressCarriesLoadAndMoment) {
  const double force = integral(-0.5, 0.5, [](double y) { return shear_stress(beam, load, y); });
  EXPECT_NEAR(force, -load, 1e-9 * load);
  EXPECT_NEAR(mean_shear_stress(beam, load, -0.5, 0.5), -load, 1e-12 * load);
  const double moment = integral(-0.5, 0.5, [](double y) { return y * fibre_stress(beam, load, 3, y); });
  EXPECT_NEAR(moment, load * 5, 1e-9 * load);
  EXPECT_EQ(shear_stress(beam, load, 0.5), 0);
  // d sigma/dx + d tau/dy = 0.
  const double y = 0.3;
  const double h = 1e-3;
  const double change = (fibre_stress(beam, load, 2 + h, y) - fibre_stress(beam, load, 2 - h, y)) +
                        (shear_stress(beam, load, y + h) - shear_stress(beam, load, y - h));
  EXPECT_NEAR(change, 0, 1e-9 * load);
}

TEST(Cantilever, DeflectionWithShearIsTwiceTheStrainEnergyOverTheLoad) {
  const double bending = integral(-0.5, 0.5, [](double y) {
    const double unit = fibre_stress(beam, load, beam.length - 1, y);  // sigma is this times (L - x)
    return unit * unit * std::pow(beam.length, 3) / 3 / beam.young;
  });
  const double shear = integral(-0.5, 0.5, [](double y) {
    return std::pow(shear_stress(beam, load, y), 2) * beam.length / beam.shear_modulus();
  });
  EXPECT_NEAR(deflection_with_shear(beam, load), (bending + shear) / load, 1e-9 * bending / load);
  EXPECT_NEAR(bending_deflection(beam, load), bending / load, 1e-9 * bending / load);
}

TEST(Cantilever, ModeHasFreeEndAndItsFrequency) {
  EXPECT_NEAR(mode_deflection(beam, 0), 0, 1e-15);
  EXPECT_NEAR(mode_slope(beam, 0), 0, 1e-15);
  const double h = 1e-3;
  const double tip = beam.length;
  EXPECT_NEAR((mode_slope(beam, tip + h) - mode_slope(beam, tip - h)) / (2 * h), 0, 1e-7);
  // Rayleigh's quotient: curvature against deflection.
  double stiffness = 0;
  double mass = 0;
  constexpr int parts = 4000;
  for (int i = 0; i < parts; ++i) {
    const double x = beam.length * (i + 0.5) / parts;
    stiffness += std::pow((mode_slope(beam, x + h) - mode_slope(beam, x - h)) / (2 * h), 2);
    mass += std::pow(mode_deflection(beam, x), 2);
  }
  const double omega = std::sqrt(beam.young * beam.second_moment() * stiffness / (beam.density * beam.height * mass));
  EXPECT_NEAR(bending_frequency(beam), omega / (2 * std::acos(-1.0)), 1e-6 * bending_frequency(beam));
}

// Shear and rotary inertia lower it by terms of the order of (h/L)^2; quoted values by another solver (Runge-Kutta).
TEST(Cantilever, TimoshenkosFrequency) {
  EXPECT_NEAR(timoshenko_frequency(beam) / bending_frequency(beam), 0.988444, 1e-6);
  const Cantilever slender{160, 1, 1e9, 0, 2000};
  const Cantilever half{80, 1, 1e9, 0, 2000};
  const auto lowered = [](const Cantilever& given) {
    return 1 - timoshenko_frequency(given) / bending_frequency(given);
  };
  EXPECT_NEAR(lowered({16, 1, 1e9, 0, 2000}), 1 - 0.99744, 1e-6);
  EXPECT_NEAR(lowered(half) / lowered(slender), 4, 0.01);
}

}  // namespace
}  // namespace exact
