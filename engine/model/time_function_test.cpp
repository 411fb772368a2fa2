#include "engine/model/time_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace dda {
namespace {

// Interpolation and the standard functions are within a few units in the last place of values of order 1.
constexpr double round_off = 1e-14;

TEST(TimeFunction, ConstantIsOneAtAnyTime) {
  EXPECT_EQ(evaluate(Constant{}, -3), 1);
  EXPECT_EQ(evaluate(Constant{}, 1e9), 1);
}

TEST(TimeFunction, TableIsLinearBetweenItsPoints) {
  const PiecewiseLinear table{{1, 2, 4}, {0, 10, -10}};
  EXPECT_EQ(evaluate(table, 1), 0);
  EXPECT_NEAR(evaluate(table, 1.25), 2.5, round_off * 10);
  EXPECT_EQ(evaluate(table, 2), 10);
  EXPECT_NEAR(evaluate(table, 3), 0, round_off * 10);
  EXPECT_NEAR(evaluate(table, 3.5), -5, round_off * 10);
}

TEST(TimeFunction, TableKeepsItsEndValuesOutside) {
  const PiecewiseLinear table{{1, 2}, {3, 7}};
  EXPECT_EQ(evaluate(table, -100), 3);
  EXPECT_EQ(evaluate(table, 2.5), 7);
  const PiecewiseLinear single{{1}, {5}};
  EXPECT_EQ(evaluate(single, 0), 5);
  EXPECT_EQ(evaluate(single, 1), 5);
  EXPECT_EQ(evaluate(single, 2), 5);
}

TEST(TimeFunction, OneSineCycleAsOnTheBarOfTheThesis) {
  const SineCycles sine{100, 1, 0};
  EXPECT_EQ(evaluate(sine, -0.001), 0);
  EXPECT_EQ(evaluate(sine, 0), 0);
  EXPECT_NEAR(evaluate(sine, 0.0025), 1, round_off);
  EXPECT_NEAR(evaluate(sine, 0.0075), -1, round_off);
  EXPECT_NEAR(evaluate(sine, 0.001), std::sin(0.2 * std::numbers::pi), round_off);
  EXPECT_EQ(evaluate(sine, 0.01), 0);
  EXPECT_EQ(evaluate(sine, 0.0125), 0);
}

TEST(TimeFunction, SineStartsLateAndRunsForItsCyclesOnly) {
  const SineCycles sine{2, 2.5, 3};
  EXPECT_EQ(evaluate(sine, 2.9), 0);
  EXPECT_NEAR(evaluate(sine, 3.125), 1, round_off);
  EXPECT_NEAR(evaluate(sine, 4.125), 1, 10 * round_off);
  EXPECT_EQ(evaluate(sine, 4.375), 0);
}

TEST(TimeFunction, SineWithoutEndGoesOn) {
  const SineCycles sine{1, std::numeric_limits<double>::infinity(), 0};
  EXPECT_NEAR(evaluate(sine, 1000.25), 1, 1e-11);  // round-off of a phase of 6000 rad
}

TEST(TimeFunction, DecayJumpsToOneAndFallsByItsTime) {
  const ExponentialDecay decay{0.002, 0.01};
  EXPECT_EQ(evaluate(decay, 0.0099), 0);
  EXPECT_EQ(evaluate(decay, 0.01), 1);
  EXPECT_NEAR(evaluate(decay, 0.012), 1 / std::numbers::e, round_off);
  EXPECT_NEAR(evaluate(decay, 0.016), std::exp(-3), round_off);
}

TEST(TimeFunction, DecayRisesInAStraightLineWhereItHasARise) {
  const ExponentialDecay decay{0.002, 0.01, 0.004};
  EXPECT_EQ(evaluate(decay, 0.0099), 0);
  EXPECT_EQ(evaluate(decay, 0.01), 0);
  EXPECT_NEAR(evaluate(decay, 0.011), 0.25, round_off);
  EXPECT_NEAR(evaluate(decay, 0.014), 1, round_off);
  EXPECT_NEAR(evaluate(decay, 0.016), 1 / std::numbers::e, round_off);
}

}  // namespace
}  // namespace dda
