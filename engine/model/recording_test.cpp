#include "engine/model/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/error.h"

namespace dda {
namespace {

constexpr double round_off = 1e-14;  // of a handful of operations on numbers of order 1 to 10

// 2 s at unequal intervals: up to 6 in 0.5 s, down to -2 at 1.5 s, back to 1 at 2 s.
Recording ground() { return {"ground", {10, 10.5, 11.5, 12}, {0, 6, -2, 1}}; }

TEST(Recording, StraightLinesBetweenItsSamplesAndNothingOutside) {
  const Recording record = ground();
  EXPECT_EQ(record.value(9.99), 0);
  EXPECT_EQ(record.value(10.25), 3);
  EXPECT_EQ(record.value(10.5), 6);
  EXPECT_EQ(record.value(11), 2);
  EXPECT_EQ(record.value(12), 1);
  EXPECT_EQ(record.value(12.01), 0);
  EXPECT_EQ(record.slope(10.25), 12);
  EXPECT_EQ(record.slope(10.5), -8);
  EXPECT_EQ(record.slope(9), 0);
  EXPECT_EQ(record.slope(12), 0);
  EXPECT_EQ(record.peak(), 6);
  EXPECT_EQ(record.duration(), 2);
  EXPECT_NEAR(record.mean_interval(), 2.0 / 3, round_off);
}

// By hand: with s the time since a sample, v = 6 s^2 and u = 2 s^3 in the first interval (1.5 and 0.25 at its end),
// v = 1.5 + 6 s - 4 s^2 and u = 0.25 + 1.5 s + 3 s^2 - 4/3 s^3 in the second (3.5 and 0.25 + 1.5 + 3 - 4/3 at its end).
TEST(Recording, IntegralsAreQuadraticAndCubic) {
  const Recording record = ground();
  EXPECT_EQ(record.integral(9), 0);
  EXPECT_EQ(record.second_integral(10), 0);
  EXPECT_NEAR(record.integral(10.25), 6 * 0.0625, round_off);
  EXPECT_NEAR(record.second_integral(10.25), 2 * 0.015625, round_off);
  EXPECT_NEAR(record.integral(10.5), 1.5, round_off);
  EXPECT_NEAR(record.second_integral(10.5), 0.25, round_off);
  EXPECT_NEAR(record.integral(10.9), 1.5 + 6 * 0.4 - 4 * 0.16, 10 * round_off);
  EXPECT_NEAR(record.second_integral(10.9), 0.25 + 0.6 + 0.48 - 4.0 / 3 * 0.064, 10 * round_off);
  EXPECT_NEAR(record.integral(11.5), 3.5, round_off);
  EXPECT_NEAR(record.second_integral(11.5), 4.75 - 4.0 / 3, 10 * round_off);
}

// After the last sample there is no acceleration: velocity stays, displacement grows by it.
TEST(Recording, DriftsOnWithTheVelocityAtItsEnd) {
  const Recording record = ground();
  const double velocity = 3.5 + 0.5 * (-2 + 1) / 2;
  EXPECT_NEAR(record.integral(12), velocity, round_off);
  EXPECT_NEAR(record.integral(100), velocity, round_off);
  EXPECT_NEAR(record.second_integral(15) - record.second_integral(12), 3 * velocity, 100 * round_off);
}

TEST(Recording, CorrectedLeavesNoVelocityAndDisplacement) {
  const Recording record = ground().corrected();
  EXPECT_NEAR(record.integral(12), 0, 10 * round_off);
  EXPECT_NEAR(record.second_integral(12), 0, 10 * round_off);
  // What was taken away is one straight line.
  const Recording original = ground();
  const double at_start = original.value(10) - record.value(10);
  const double at_end = original.value(12) - record.value(12);
  for (const double time : {10.5, 11.0, 11.5})
    EXPECT_NEAR(original.value(time) - record.value(time), at_start + (at_end - at_start) * (time - 10) / 2,
                10 * round_off);
}

TEST(Recording, RefusesWhatIsNoSignal) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Recording("", {0}, {1}), InputError);
  EXPECT_THROW(Recording("", {0, 1}, {1}), InputError);
  EXPECT_THROW(Recording("", {0, 0}, {1, 1}), InputError);
  EXPECT_THROW(Recording("", {0, -1}, {1, 1}), InputError);
  EXPECT_THROW(Recording("", {0, 1}, {1, nan}), InputError);
  EXPECT_THROW(Recording("", {0, nan}, {1, 1}), InputError);
}

}  // namespace
}  // namespace dda
