#include "verification/exact/coulomb_sliding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double gravity = 9.81;
constexpr double degree = std::numbers::pi / 180;

// The equation itself, in short steps of constant forces: an integration that shares nothing with the closed form.
double stepped_position(const Harmonic& drive, const Harmonic& limit, double end, double velocity, int steps) {
  double position = 0;
  const double dt = end / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * dt;
    const double free = velocity + dt * drive.at(t);
    const double held = std::copysign(std::max(0.0, std::abs(free) - dt * limit.at(t)), free);
    position += dt * (velocity + held) / 2;
    velocity = held;
  }
  return position;
}

TEST(CoulombSlider, Incline) {
  for (const double friction : {0.0, 10.0, 25.0}) {
    const auto [drive, limit] = incline_forces(gravity, 30 * degree, friction * degree);
    const CoulombSlider slider(drive, limit, 0, 2);
    const double acceleration = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(friction * degree));
    EXPECT_NEAR(slider.position(2), acceleration * 2, 1e-14 * gravity);
    EXPECT_NEAR(slider.velocity(1.5), acceleration * 1.5, 1e-14 * gravity);
  }
  const auto [drive, limit] = incline_forces(gravity, 30 * degree, 35 * degree);
  EXPECT_EQ(CoulombSlider(drive, limit, 0, 8).position(8), 0);
}

TEST(CoulombSlider, ComesToRest) {
  const CoulombSlider slider({}, {0.5 * gravity}, 1, 5, 3.0);
  ASSERT_EQ(slider.phases().size(), 2U);
  EXPECT_NEAR(slider.phases()[1].start, 1 + 3 / (0.5 * gravity), 1e-12);
  EXPECT_NEAR(slider.position(5), stopping_distance(3, 0.5, gravity), 1e-12);
  EXPECT_EQ(slider.velocity(4), 0);
}

TEST(CoulombSlider, AgreesWithSteppingTheEquation) {
  const Harmonic shaking{0, 4, 2 * std::numbers::pi, 0.3};
  for (const double friction : {28.0, 32.0}) {
    const auto [drive, limit] = incline_forces(gravity, 30 * degree, friction * degree, shaking);
    const CoulombSlider slider(drive, limit, 0, 3);
    // Steps of constant forces are off by dt^2 at smooth times and dt where sliding starts or ends.
    EXPECT_NEAR(slider.position(3), stepped_position(drive, limit, 3, 0, 3000000), 1e-8) << friction;
  }
}

TEST(CoulombSlider, InclineForcesAreThoseOfTheCatalogue) {
  const double slope = 0.4;
  const double friction = 0.3;
  const Harmonic shaking{0.2, 3, 5, 1};
  const auto [drive, limit] = incline_forces(gravity, slope, friction, shaking);
  for (const double t : {0.1, 0.7, 1.9}) {
    const double expected = gravity * (std::sin(slope) - std::cos(slope) * std::tan(friction)) +
                            shaking.at(t) * (std::cos(slope) + std::sin(slope) * std::tan(friction));
    EXPECT_NEAR(drive.at(t) - limit.at(t), expected, 1e-14);
  }
}

// On a base that shakes with less than mu g the block goes along; with more it slides both ways, never faster than mu
// g.
TEST(CoulombSlider, OnAMovingBase) {
  const double hold = 0.3 * gravity;
  EXPECT_EQ(CoulombSlider({0, 0.99 * hold, 6, 0}, {hold}, 0, 10).phases().size(), 1U);
  const CoulombSlider slider({0, 2 * hold, 6, 0}, {hold}, 0, 10);
  EXPECT_NEAR(slider.phases()[1].start, std::asin(0.5) / 6, 1e-12);
  for (double t = 0; t < 10; t += 0.01) {
    const double base = -2 * hold * std::sin(6 * t);
    EXPECT_LE(std::abs(base + slider.acceleration(t)), hold * (1 + 1e-9)) << t;
  }
}

// Block of 1 kg, 8 cos t N, mu = 0.8: Potra, Anitescu, Gavrea & Trinkle (2006), whose histories Solfec's test suite
// keeps as numbers (inp/tests of parmes/solfec-1.0): a rigid-body run in steps of 1 ms, good to about 1 % of its travel
// of 13 mm; velocities are asked for one step late, at up to 0.15 m/s2.
TEST(CoulombSlider, BlockOnAFrictionalTable) {
  const CoulombSlider slider({0, 8, 1, std::numbers::pi / 2}, {0.8 * gravity}, 0, 10);
  EXPECT_NEAR(slider.position(2), 0.00435080898, 1e-4);
  EXPECT_NEAR(slider.position(5), -0.00870878769, 1e-4);
  EXPECT_NEAR(slider.position(8), 0.00441870359, 1e-4);
  EXPECT_NEAR(slider.velocity(0.15), 0.0183699246991, 3e-4);
  EXPECT_NEAR(slider.velocity(3.15), -0.021223275136, 3e-4);
  EXPECT_NEAR(slider.velocity(6.15), 0.00288766940501, 3e-4);
}

}  // namespace
}  // namespace exact
