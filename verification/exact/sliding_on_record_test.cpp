#include "verification/exact/sliding_on_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "verification/exact/coulomb_sliding.h"

namespace exact {
namespace {

constexpr double gravity = 9.81;

// Newmark 1965: the plane goes off with A for a time T; both move alike when friction has brought the block to
// V = A T, and until then it has stayed behind by V^2/(2 N) - V^2/(2 A), N = mu g.
TEST(SlideOnRecord, RectangularPulseIsNewmarksFormula) {
  const SlidingPlane level{gravity, 0, 0.2};
  const double yield = 0.2 * gravity;
  const double speed = 5 * 0.4;
  const Accelerogram pulse{{0, 0.4}, {5, 5}};
  const double expected = speed * speed / (2 * yield) - speed * speed / (2 * 5);
  const BaseMotion motion = slide_on_record(level, pulse, 3);
  EXPECT_NEAR(motion.displacement, expected, 1e-14);
  EXPECT_EQ(motion.velocity, 0);
  EXPECT_EQ(slide_on_record(level, {{0, 0.4}, {1.9, 1.9}}, 3).displacement, 0);  // below the yield acceleration
}

// A block that sticks and slides both ways in turn. A sine of n samples a period is a broken line that differs from it
// by a relative (pi/n)^2/2.
TEST(SlideOnRecord, SineIsThatOfTheHarmonicSolution) {
  constexpr double omega = 4 * std::numbers::pi;
  constexpr int samples = 2000;
  for (const double slope : {0.0, 0.2}) {
    const double friction = slope + 0.3;
    Accelerogram record;
    for (int i = 0; i <= 4 * samples; ++i) {
      record.times.push_back(0.5 * i / samples);
      record.values.push_back(6 * std::sin(omega * record.times.back()));
    }
    const auto [drive, limit] = incline_forces(gravity, slope, std::atan(friction), {0, 6, omega, 0});
    const CoulombSlider exact(drive, limit, 0, 2);
    ASSERT_GT(exact.phases().size(), 4U);
    for (const double t : {0.3, 0.77, 1.41, 2.0}) {
      const BaseMotion motion = slide_on_record({gravity, slope, friction}, record, t);
      EXPECT_NEAR(motion.displacement, exact.position(t), 4e-6 * std::abs(exact.position(t)) + 1e-7);
      EXPECT_NEAR(motion.velocity, exact.velocity(t), 1e-5);
    }
  }
}

// Any number of samples on the same straight lines is the same record.
TEST(SlideOnRecord, DoesNotDependOnWhereTheRecordIsCut) {
  const Accelerogram coarse{{0, 0.3, 0.5, 1.1, 1.3}, {0, 4, -6, 5, 0.5}};
  Accelerogram fine;
  for (std::size_t i = 1; i < coarse.times.size(); ++i)
    for (int part = 0; part < 7; ++part) {
      const double share = part / 7.0;
      fine.times.push_back(coarse.times[i - 1] + share * (coarse.times[i] - coarse.times[i - 1]));
      fine.values.push_back(coarse.values[i - 1] + share * (coarse.values[i] - coarse.values[i - 1]));
    }
  fine.times.push_back(1.3);
  fine.values.push_back(0.5);
  const SlidingPlane plane{gravity, 0.1, 0.3};
  for (const double t : {0.25, 0.6, 1.2, 2.0}) {
    const BaseMotion expected = slide_on_record(plane, coarse, t);
    EXPECT_NEAR(slide_on_record(plane, fine, t).displacement, expected.displacement, 1e-14);
    EXPECT_NEAR(slide_on_record(plane, fine, t).velocity, expected.velocity, 1e-13);
  }
  EXPECT_GT(std::abs(slide_on_record(plane, coarse, 2).displacement), 0.01);
}

}  // namespace
}  // namespace exact
