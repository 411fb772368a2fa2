#include "verification/exact/viscous_reflection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Speeds of nu = 1/4 in plane strain.
ViscousEdge edge_of(double across, double along) { return {std::sqrt(3.0), 1, across, along}; }

TEST(ViscousEdge, EnergyIsReflectedOrAbsorbed) {
  for (const PlaneWave incident : {PlaneWave::p, PlaneWave::s})
    for (const double across : {0.0, 0.3, 1.0, 4.0})
      for (const double along : {0.0, 0.7, 1.0, 10.0})
        for (double angle = 0; angle < 90; angle += 7) {
          const Reflection r = reflect(edge_of(across, along), incident, angle * degree);
          EXPECT_NEAR(r.p_energy + r.s_energy + r.absorbed, 1, 1e-13);
          EXPECT_GE(r.p_energy, 0);
          EXPECT_GE(r.s_energy, 0);
        }
}

// (1 - a)/(1 + a) of the displacement along the wave's own direction: the polarization of a reflected P wave has turned
// round, and so has that of a reflected S wave.
TEST(ViscousEdge, AtNormalIncidenceIsTheEndOfABar) {
  for (const double ratio : {0.0, 0.1, 1.0, 10.0}) {
    const double expected = -(1 - ratio) / (1 + ratio);
    const Reflection p = reflect(edge_of(ratio, 0.4), PlaneWave::p, 0);
    EXPECT_NEAR(std::abs(p.p - expected), 0, 1e-15);
    EXPECT_NEAR(std::abs(p.s), 0, 1e-15);
    const Reflection s = reflect(edge_of(0.4, ratio), PlaneWave::s, 0);
    EXPECT_NEAR(std::abs(s.s - expected), 0, 1e-15);
    EXPECT_NEAR(std::abs(s.p), 0, 1e-15);
  }
}

// Free surface in slownesses (Aki & Richards 2002, eq. 5.27 and 5.32): what is common to all coefficients is
// (1/b^2 - 2 p^2)^2 + 4 p^2 q_a q_b, with the vertical slownesses q_a of P and q_b of S.
TEST(ViscousEdge, WithoutDashpotsIsTheFreeSurface) {
  const ViscousEdge free = edge_of(0, 0);
  for (const double angle : {10.0, 25.0, 45.0, 70.0, 85.0}) {
    for (const PlaneWave incident : {PlaneWave::p, PlaneWave::s}) {
      const double p = std::sin(angle * degree) / (incident == PlaneWave::p ? free.p_speed : free.s_speed);
      const auto root = [&](double speed) { return std::conj(std::sqrt(std::complex(1 / speed / speed - p * p))); };
      const auto qa = root(free.p_speed);
      const auto qb = root(free.s_speed);
      const double b = 1 / (free.s_speed * free.s_speed) - 2 * p * p;
      const auto sum = b * b + 4 * p * p * qa * qb;
      const Reflection r = reflect(free, incident, angle * degree);
      const double share = free.p_speed / free.s_speed;
      if (incident == PlaneWave::p) {
        EXPECT_NEAR(std::abs(r.p - (4 * p * p * qa * qb - b * b) / sum), 0, 1e-13);
        EXPECT_NEAR(std::abs(r.s), std::abs(4 * share * p * qa * b / sum), 1e-13);
      } else {
        EXPECT_NEAR(std::abs(r.s), std::abs((b * b - 4 * p * p * qa * qb) / sum), 1e-13);
        EXPECT_NEAR(std::abs(r.p), std::abs(4 / share * p * qb * b / sum), 1e-13);
      }
    }
  }
}

// Held without motion: cos(t_p + t_s)/cos(t_p - t_s) (Miklowitz 1978, section 3.2).
TEST(ViscousEdge, OfEndlessImpedanceIsRigid) {
  const ViscousEdge stiff = edge_of(1e12, 1e12);
  for (const double angle : {0.0, 20.0, 50.0, 80.0}) {
    const double p_angle = angle * degree;
    const double s_angle = std::asin(std::sin(p_angle) * stiff.s_speed / stiff.p_speed);
    const Reflection r = reflect(stiff, PlaneWave::p, p_angle);
    EXPECT_NEAR(std::abs(r.p - std::cos(p_angle + s_angle) / std::cos(p_angle - s_angle)), 0, 1e-10);
  }
}

// Energies sent back of the verification catalogue, to its digits: nu = 1/4, matched impedances.
TEST(ViscousEdge, IsTheCatalogue) {
  const auto energy = [](PlaneWave incident, double angle) {
    const Reflection r = reflect(edge_of(1, 1), incident, angle * degree);
    return r.p_energy + r.s_energy;
  };
  for (const auto& [angle, expected] : {std::pair{30.0, .0003}, {45.0, .0039}, {60.0, .036}, {70.0, .117}})
    EXPECT_NEAR(energy(PlaneWave::p, angle), expected, angle < 50 ? 6e-5 : 6e-4) << angle;
  for (const auto& [angle, expected] : {std::pair{30.0, .036}, {45.0, .029}, {60.0, .113}})
    EXPECT_NEAR(energy(PlaneWave::s, angle), expected, 6e-4) << angle;
}

}  // namespace
}  // namespace exact
