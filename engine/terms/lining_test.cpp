#include "engine/terms/lining.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace dda {
namespace {

constexpr double length = 1.5;

LiningSection section() { return lining_section(0.2, 20e9, 0.2); }

// A beam along x between blocks whose centroids lie at its ends: their unknowns are those of the ends.
LiningRows straight() { return lining_rows({length, 0}, {{0, 0}, {1, 0}}, {{0, 0}, {1, 0}}); }

Vec6 end(double u, double v, double turn) {
  Vec6 d = Vec6::Zero();
  d.head<3>() << u, v, turn;
  return d;
}

TEST(Lining, StiffnessIsThatOfTimoshenkosBeam) {
  // A cantilever under a force P at its tip: v = P L^3/(3 E I) + P L/(k G A), turn = P L^2/(2 E I).
  const double load = 1e4;
  const LiningSection s = section();
  const double deflection = load * std::pow(length, 3) / (3 * s.bending) + load * length / s.shear;
  const double turn = load * length * length / (2 * s.bending);
  const Vec3 gap = straight().b * end(0, deflection, turn);
  const Vec3 force = lining_stiffness(s, length).cwiseProduct(gap);
  const Vec6 at_tip = straight().b.transpose() * force;
  EXPECT_NEAR(at_tip(1), load, 1e-9 * load);
  EXPECT_NEAR(at_tip(2), 0, 1e-9 * load * length);
  EXPECT_NEAR(force(2) / length, -load, 1e-9 * load) << "the moment grows towards the tip, from -P L to 0";
  EXPECT_NEAR(force(1) - force(2) / 2, load * length, 1e-9 * load * length)
      << "a tip pulled to the left bends the beam to its left";
  EXPECT_NEAR(force(1) + force(2) / 2, 0, 1e-9 * load * length);
  const Vec3 stretched = lining_stiffness(s, length).cwiseProduct(straight().b * end(1e-3, 0, 0));
  EXPECT_NEAR(stretched(0), s.axial * 1e-3 / length, 1e-9 * stretched(0));
}

TEST(Lining, ShortElementsAreStiffInShearAsASectionIs) {
  const Vec3 stiffness = lining_stiffness(section(), 1e-3);
  EXPECT_NEAR(stiffness(2), section().shear * 1e-3, 1e-4 * stiffness(2)) << "Q = V L, V = k G A times the angle";
}

TEST(Lining, RigidMotionMovesNoGap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anything(-2, 2);
  const auto point = [&] { return Vec2(anything(random), anything(random)); };
  for (int i = 0; i < 100; ++i) {
    const Vec2 from = point();
    const Vec2 to = point();
    const Vec2 centroid_a = point();
    const Vec2 centroid_b = point();
    const LiningRows rows =
        lining_rows(to - from, {from - centroid_a, point().normalized()}, {to - centroid_b, point().normalized()});
    const double turn = anything(random);
    const Vec2 shift = point();
    const auto moved = [&](const Vec2& centroid) {
      return end(shift.x() - turn * centroid.y(), shift.y() + turn * centroid.x(), turn);
    };
    EXPECT_LT((rows.a * moved(centroid_a) + rows.b * moved(centroid_b)).norm(), 1e-13);
  }
}

// The faces of a regular polygon in a plane that is sheared purely: u = (g x, -g y). A thin ring in it stretches by
// -g cos(2 phi) and turns by g sin(2 phi), so that M = 2 E I g cos(2 phi)/r and V = dM/ds = -4 E I g sin(2 phi)/r^2.
TEST(Lining, FacesOfAPolygonGiveTheForcesOfARing) {
  constexpr double shear = 1e-4, radius = 2.5;
  LiningSection s = section();
  s.shear *= 1e9;  // a section of thin shells, which stays normal to its axis
  double before = 1;
  for (const int faces : {16, 32, 64}) {
    double worst = 0;
    for (int i = 0; i < faces; ++i) {
      const double step = 2 * std::numbers::pi / faces;
      const auto grip = [&](double at) { return LiningGrip{Vec2::Zero(), {-std::sin(at), std::cos(at)}}; };
      const auto point = [&](double at) -> Vec2 { return radius * Vec2(std::cos(at), std::sin(at)); };
      const auto motion = [&](double at) {
        Vec6 d;
        d << shear * point(at).x(), -shear * point(at).y(), 0, shear, -shear, 0;
        return d;
      };
      const double from = i * step;
      const double to = from + step;
      const Vec2 chord = point(to) - point(from);
      const LiningRows rows = lining_rows(chord, grip(from), grip(to));
      const Vec3 force = lining_stiffness(s, chord.norm()).cwiseProduct(rows.a * motion(from) + rows.b * motion(to));
      const double phi = (from + to) / 2;
      const double thrust = -s.axial * shear * std::cos(2 * phi);
      const double moment = 2 * s.bending * shear * std::cos(2 * phi) / radius;
      const double slope = -4 * s.bending * shear * std::sin(2 * phi) / (radius * radius);
      worst = std::max({worst, std::abs(force(0) - thrust) / (s.axial * shear),
                        std::abs(force(1) - moment) / (2 * s.bending * shear / radius),
                        std::abs(force(2) / chord.norm() - slope) / (4 * s.bending * shear / (radius * radius))});
    }
    EXPECT_LT(worst, before / 3.5) << "of second order in the length of faces";
    before = worst;
  }
}

}  // namespace
}  // namespace dda
