#include "engine/advice/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr CoarseBounds coarse{1, 10};
constexpr double found = 1.1;  // the search ends with brackets of 2^(1/16) = 1.044

TEST(Limits, TheLargestThatKeepTheError) {
  const auto error = [](double dt, double scale) { return std::optional(dt * dt + 1e-3 * scale * scale); };
  const WaveLimits limits = find_limits(error, 0.01, coarse, 0.01);
  ASSERT_TRUE(limits.dt && limits.scale);
  EXPECT_LE(error(*limits.dt, 1).value(), 0.01);
  EXPECT_GT(error(found * *limits.dt, 1).value(), 0.01);
  EXPECT_LE(error(0.01, *limits.scale).value(), 0.01);
  EXPECT_GT(error(0.01, found * *limits.scale).value(), 0.01);
  EXPECT_FALSE(limits.both_dt.has_value());
}

TEST(Limits, BothWhereNeitherAloneIsEnough) {
  const auto error = [](double dt, double scale) { return std::optional(dt * dt + 0.02 * scale * scale); };
  const WaveLimits limits = find_limits(error, 0.2, coarse, 0.01);
  EXPECT_FALSE(limits.dt || limits.scale);
  ASSERT_TRUE(limits.both_dt && limits.both_scale);
  EXPECT_LE(error(*limits.both_dt, *limits.both_scale).value(), 0.01);
}

TEST(Limits, NoneWhereNothingHelps) {
  const WaveLimits limits = find_limits([](double, double) { return std::optional(0.5); }, 0.2, coarse, 0.01);
  EXPECT_FALSE(limits.dt || limits.scale || limits.both_dt || limits.both_scale);
  const WaveLimits lost = find_limits([](double, double) { return std::optional<double>(); }, 0.2, coarse, 0.01);
  EXPECT_FALSE(lost.dt || lost.both_dt);
  EXPECT_EQ(lost.finest.dt, coarse.dt / 1024);
  EXPECT_EQ(lost.finest.scale, coarse.scale / 1024);
}

// The finest that is said to have been tried was.
TEST(Limits, AreLookedForDownToTheLeast) {
  double least_dt = 1, least_scale = 10;
  const auto error = [&](double dt, double scale) {
    least_dt = std::min(least_dt, dt);
    least_scale = std::min(least_scale, scale);
    return std::optional(dt <= coarse.dt / 1024 ? 0.0 : 0.5);
  };
  const WaveLimits limits = find_limits(error, 0.2, coarse, 0.01);
  ASSERT_TRUE(limits.dt.has_value());
  EXPECT_GE(*limits.dt, limits.finest.dt);
  EXPECT_LE(least_dt, limits.finest.dt);
  EXPECT_LE(least_scale, limits.finest.scale);
}

// An error that passes zero at one dt between larger ones is no reason to take that dt.
TEST(Limits, AZeroInPassingDoesNotCount) {
  const auto error = [](double dt, double) { return std::optional(std::abs(dt - 0.5) < 0.01 ? 0.0 : dt); };
  EXPECT_LT(find_limits(error, 0.001, coarse, 0.01).dt.value(), 0.011);
}

}  // namespace
}  // namespace dda
