#include "verification/exact/pressurised_cavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "verification/exact/signal.h"
#include "verification/exact/wave_speeds.h"

namespace exact {
namespace {

using Complex = std::complex<double>;

constexpr double density = 2500;
constexpr double young = 25e9;

Cavity plane_strain(double poisson, double radius = 1) {
  return {radius, density * std::pow(p_speed_plane_strain(young, poisson, density), 2),
          density * std::pow(s_speed(young, poisson, density), 2), density};
}

// K_order(z) = integral over t > 0 of exp(-z cosh t) cosh(order t), Re z > 0 (Abramowitz & Stegun 9.6.24), along
// t = u - i arg(z) tanh u, on which the integrand soon stops turning: the trapezoidal rule converges exponentially.
Complex bessel_k(int order, Complex z) {
  constexpr double step = 0.01;
  const double angle = std::arg(z);
  Complex sum = 0.5 * std::exp(-z) * Complex(1, -angle);
  for (int i = 1;; ++i) {
    const double u = i * step;
    const Complex t(u, -angle * std::tanh(u));
    const Complex exponent = -z * std::cosh(t);
    if (exponent.real() < -z.real() - 45) return step * sum;
    sum +=
        std::exp(exponent) * std::cosh(static_cast<double>(order) * t) * Complex(1, -angle / std::pow(std::cosh(u), 2));
  }
}

TEST(BesselK, AgreesWithTheStandardLibrary) {
  for (const double x : {0.1, 1.0, 5.0})
    for (const int order : {0, 1})
      EXPECT_NEAR(bessel_k(order, x).real() / std::cyl_bessel_k(order, x), 1, 1e-12) << order << " " << x;
}

// K_0' = -K_1; central differences of 1e-4 |z| are good to 1e-6 |z|^2.
TEST(BesselK, HasItsDerivative) {
  for (const Complex z : {Complex(0.3, 1), Complex(0.4, 20), Complex(2, 150)}) {
    const double h = 1e-4;
    const Complex slope = (bessel_k(0, z + h) - bessel_k(0, z - h)) / (2 * h);
    EXPECT_LT(std::abs(slope / bessel_k(1, z) + 1.0), 1e-7) << z;
  }
}

// The transform of the motion outside of the cavity is A K_1(s r/c), with A from the pressure on the wall.
struct Transformed {
  Complex radial, hoop, velocity;
};

Transformed transformed(const Cavity& cavity, Complex pressure, double r, Complex s) {
  const Complex k = s / std::sqrt(cavity.p_modulus / cavity.density);
  const double m = cavity.p_modulus;
  const double lambda = m - 2 * cavity.shear;
  const double a = cavity.radius;
  const Complex amplitude = pressure / (m * k * bessel_k(0, k * a) + 2 * cavity.shear / a * bessel_k(1, k * a));
  const Complex u = amplitude * bessel_k(1, k * r);
  const Complex slope = -amplitude * (k * bessel_k(0, k * r) + bessel_k(1, k * r) / r);
  return {m * slope + lambda * u / r, lambda * slope + m * u / r, s * u};
}

constexpr double tau = 0.4e-3;
constexpr double peak_scale = 1e7;
double pulse(double t) { return t <= 0 ? 0 : peak_scale * std::pow(t / tau, 2) * std::exp(-t / tau); }

struct Motion {
  double radial = 0, hoop = 0, velocity = 0;
};

const std::vector<double> radii{1.4, 2.3, 6.1};
const std::vector<double> moments{0.7e-3, 1.0e-3, 1.3e-3, 1.8e-3, 2.4e-3, 3.1e-3, 4.1e-3};

// exp(sigma t)/pi times the integral over omega > 0 of Re(F(sigma + i omega) exp(i omega t)), by the trapezoidal rule;
// with sigma T = 20 what wraps around after T is 2e-9. The transform of (t/tau)^2 exp(-t/tau) falls as 1/s^3.
std::vector<Motion> inverted(const Cavity& cavity, double r) {
  const double span = 16e-3;  // s, T above
  const double step = std::numbers::pi / span;
  std::vector<Motion> sums(moments.size());
  for (int i = 0; i < 4000; ++i) {
    const Complex s(20 / span, i * step);
    const Transformed f = transformed(cavity, peak_scale * 2.0 / tau / tau / std::pow(s + 1 / tau, 3), r, s);
    for (std::size_t j = 0; j < moments.size(); ++j) {
      const Complex turn = std::exp(s * moments[j]) * (step / std::numbers::pi * (i == 0 ? 0.5 : 1.0));
      sums[j].radial += (f.radial * turn).real();
      sums[j].hoop += (f.hoop * turn).real();
      sums[j].velocity += (f.velocity * turn).real();
    }
  }
  return sums;
}

std::vector<std::vector<Motion>> inverted_everywhere(const Cavity& cavity) {
  std::vector<std::vector<Motion>> all;
  for (const double r : radii) all.push_back(inverted(cavity, r));
  return all;
}

// Root mean squares of the differences at all radii and moments; velocities times the impedance.
Motion mean_errors(const Cavity& cavity, int rings_per_radius, const std::vector<std::vector<Motion>>& exact) {
  const CavityMotion motion = pressurised_cavity(cavity, pulse, radii, 5e-3, rings_per_radius);
  Motion sum;
  for (std::size_t i = 0; i < radii.size(); ++i)
    for (std::size_t j = 0; j < moments.size(); ++j) {
      const auto error = [&](const std::vector<double>& values, double expected) {
        return std::pow(interpolate({values, motion.interval, 0}, moments[j]) - expected, 2);
      };
      sum.radial += error(motion.histories[i].radial_stress, exact[i][j].radial);
      sum.hoop += error(motion.histories[i].hoop_stress, exact[i][j].hoop);
      sum.velocity += cavity.p_modulus * density * error(motion.histories[i].velocity, exact[i][j].velocity);
    }
  const auto count = static_cast<double>(radii.size() * moments.size());
  return {std::sqrt(sum.radial / count), std::sqrt(sum.hoop / count), std::sqrt(sum.velocity / count)};
}

// Against Laplace transforms inverted numerically: an independent solution. The errors are those of second order.
TEST(PressurisedCavity, ConvergesToTheInvertedTransform) {
  const Cavity cavity = plane_strain(0.25);
  const auto exact = inverted_everywhere(cavity);
  const Motion coarse = mean_errors(cavity, 20, exact);
  const Motion fine = mean_errors(cavity, 40, exact);
  EXPECT_LT(fine.radial, 2e-5 * peak_scale);  // measured: 1.4e-5, 0.9e-5 and 0.5e-5
  EXPECT_LT(fine.hoop, 2e-5 * peak_scale);
  EXPECT_LT(fine.velocity, 2e-5 * peak_scale);
  EXPECT_NEAR(std::log2(coarse.radial / fine.radial), 2, 0.15);
  EXPECT_NEAR(std::log2(coarse.hoop / fine.hoop), 2, 0.15);
  EXPECT_NEAR(std::log2(coarse.velocity / fine.velocity), 2, 0.15);
}

TEST(PressurisedCavity, HeldPressureEndsInLamesStresses) {
  const Cavity cavity = plane_strain(0.25, 2);
  const std::vector<double> places{2, 3, 5};
  const double rise = 2e-3;
  const auto pressure = [rise](double t) { return 1e6 * std::min(t / rise, 1.0); };
  const CavityMotion motion = pressurised_cavity(cavity, pressure, places, 0.15, 20);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const RadialStress held = lame_ring(2, std::numeric_limits<double>::infinity(), 1e6, 0, places[i]);
    // What is left of the wave falls as (a/(c t))^2, here 1.5e-5; rings of a/20 have up to 7e-4.
    EXPECT_NEAR(motion.histories[i].radial_stress.back(), held.radial, 1e3) << places[i];
    EXPECT_NEAR(motion.histories[i].hoop_stress.back(), held.hoop, 1e3) << places[i];
  }
}

TEST(PressurisedCavity, NothingArrivesBeforeTheWave) {
  const Cavity cavity = plane_strain(0.2);
  const double speed = std::sqrt(cavity.p_modulus / density);
  const CavityMotion motion = pressurised_cavity(cavity, pulse, {9}, 5e-3, 20);
  for (std::size_t i = 0; static_cast<double>(i) * motion.interval < 7.5 / speed; ++i)
    EXPECT_LT(std::abs(motion.histories[0].radial_stress[i]), 1e-9 * peak_scale);
}

// A circle cut suddenly into rock under the stress -p is one whose wall is pulled by p all at once: the hoop stress at
// the wall passes 2 p. Published peaks: 2.227, 2.255, 2.292 and 2.323. Half of the last digit is 5e-4; as much again is
// left for rings of a/400 and for a wall let go in the fifth part of the time a wave takes through the radius.
TEST(PressurisedCavity, SuddenExcavationPassesTheStaticHoopStress) {
  for (const auto& [poisson, peak] : {std::pair(0.2, 2.227), {0.25, 2.255}, {0.3, 2.292}, {1.0 / 3, 2.323}}) {
    const Cavity cavity = plane_strain(poisson);
    const double speed = std::sqrt(cavity.p_modulus / density);
    const auto pull = [speed](double t) { return -std::min(1.0, t * speed / 0.2); };
    const CavityMotion motion = pressurised_cavity(cavity, pull, {1}, 8 / speed, 400);
    const std::vector<double>& hoop = motion.histories[0].hoop_stress;
    const auto lowest = std::min_element(hoop.begin(), hoop.end());
    EXPECT_NEAR(1 - *lowest, peak, 1e-3) << poisson;
    const double when = speed * static_cast<double>(lowest - hoop.begin()) * motion.interval;
    EXPECT_GT(when, 3.8) << poisson;
    EXPECT_LT(when, 5.1) << poisson;
  }
}

// The same wall goes further in than p a/(2 G), where it comes to rest: by 18.2, 19.1 and 20.4 %. Half of the last
// digit is 5e-4; the rest is for rings of a/400.
TEST(PressurisedCavity, SuddenExcavationClosesMoreThanASlowOne) {
  for (const auto& [poisson, overshoot] : {std::pair(0.2, 0.182), {0.25, 0.191}, {0.3, 0.204}}) {
    const Cavity cavity = plane_strain(poisson);
    const double speed = std::sqrt(cavity.p_modulus / density);
    const auto pull = [speed](double t) { return -std::min(1.0, t * speed / 0.02); };
    const CavityMotion motion = pressurised_cavity(cavity, pull, {1}, 8 / speed, 400);
    double closed = 0;
    double most = 0;
    for (const double velocity : motion.histories[0].velocity) {
      closed -= motion.interval * velocity;
      most = std::max(most, closed);
    }
    EXPECT_NEAR(most * 2 * cavity.shear, 1 + overshoot, 1.5e-3) << poisson;
  }
}

TEST(LameRing, HasItsPressuresAtBothCircles) {
  EXPECT_NEAR(lame_ring(2, 5, 3, 1, 2).radial, -3, 1e-15);
  EXPECT_NEAR(lame_ring(2, 5, 3, 1, 5).radial, -1, 1e-15);
  EXPECT_NEAR(lame_ring(2, 5, 7, 7, 3).hoop, -7, 1e-15);
  EXPECT_NEAR(lame_ring(2, 4, 3, 0, 2).hoop, 3 * (16.0 + 4) / (16 - 4), 1e-14);  // p (b^2 + a^2)/(b^2 - a^2)
}

// By Schwarz and Christoffel the slope of the map is R (1 - w^-8)^(1/4): its length over an eighth of the circle is the
// edge. The midpoint rule is good to 1e-8 here.
TEST(OctagonSource, HasItsConformalRadius) {
  constexpr int points = 1'000'000;
  const double pi = std::numbers::pi;
  double edge_over_radius = 0;
  for (int i = 0; i < points; ++i)
    edge_over_radius += std::pow(2 * std::sin(pi * (i + 0.5) / points), 0.25) * pi / 4 / points;
  const double edge = std::sqrt(pi / (2 * (1 + std::numbers::sqrt2)));  // equal area of radius 1
  EXPECT_NEAR(octagon_source_radius(1), edge / edge_over_radius * std::sqrt(1 + 7.0 / 28 / 28), 1e-7);
}

TEST(PressurisedCavity, RefusesARadiusInside) {
  EXPECT_THROW((void)pressurised_cavity(plane_strain(0.25), pulse, {0.5}, 1e-3, 10), std::invalid_argument);
}

}  // namespace
}  // namespace exact
