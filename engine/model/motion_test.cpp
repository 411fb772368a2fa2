#include "engine/model/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace dda {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<TimeFunction> histories() {
  return {Constant{},
          PiecewiseLinear{{-1, 0.3, 0.8, 2}, {2, 1, 3, -1}},
          SineCycles{1.5, 1.75, 0.4},
          SineCycles{0.7, infinite, -0.2},
          ExponentialDecay{0.4, 0.25},
          ExponentialDecay{0.4, 0.2, 0.6},
          ExponentialDecay{0.5, -0.3, 0.45},
          Recorded{
              std::make_shared<const Recording>("", std::vector{-0.5, 0.2, 0.7, 1.4}, std::vector{1.0, 2.0, -1.0, 0.5}),
              0.35}};
}

// Moments away from every kink and jump of the histories above.
const std::vector<double> moments = {0.1, 0.33, 0.61, 0.9, 1.1, 1.31, 1.9, 2.7};

// Central differences: round-off 1e-16/h, truncation h^2 of functions with third derivatives up to 1e3.
constexpr double h = 1e-5;
constexpr double difference_tolerance = 1e-6;

TEST(Motion, VelocityAndAccelerationAreDerivatives) {
  for (const TimeFunction& history : histories())
    for (const MotionKind kind : {MotionKind::displacement, MotionKind::velocity, MotionKind::acceleration})
      for (const double t : moments) {
        const MotionFactors before = motion_at(kind, history, t - h);
        const MotionFactors now = motion_at(kind, history, t);
        const MotionFactors after = motion_at(kind, history, t + h);
        EXPECT_NEAR((after.displacement - before.displacement) / (2 * h), now.velocity, difference_tolerance)
            << history.index() << " at " << t;
        EXPECT_NEAR((after.velocity - before.velocity) / (2 * h), now.acceleration, 10 * difference_tolerance)
            << history.index() << " at " << t;
      }
}

TEST(Motion, TheHistoryIsWhatIsPrescribed) {
  for (const TimeFunction& history : histories())
    for (const double t : moments) {
      EXPECT_EQ(motion_at(MotionKind::displacement, history, t).displacement, evaluate(history, t));
      EXPECT_EQ(motion_at(MotionKind::velocity, history, t).velocity, evaluate(history, t));
      EXPECT_EQ(motion_at(MotionKind::acceleration, history, t).acceleration, evaluate(history, t));
    }
}

// Also where the history has run before t = 0.
TEST(Motion, OfVelocitiesAndAccelerationsStartsFromRest) {
  for (const TimeFunction& history : histories()) {
    EXPECT_EQ(motion_at(MotionKind::velocity, history, 0).displacement, 0);
    EXPECT_EQ(motion_at(MotionKind::acceleration, history, 0).displacement, 0);
    EXPECT_EQ(motion_at(MotionKind::acceleration, history, 0).velocity, 0);
  }
}

// Integrals also where the differences above skip a kink or a jump: continuous over all of them.
TEST(Motion, IntegralsAreContinuous) {
  for (const TimeFunction& history : histories())
    for (const double t : {0.15, 0.2, 0.25, 0.3, 0.4, 0.55, 0.8, 1.05, 1.75, 2.0}) {
      const MotionFactors before = motion_at(MotionKind::acceleration, history, t - 1e-9);
      const MotionFactors after = motion_at(MotionKind::acceleration, history, t + 1e-9);
      EXPECT_NEAR(before.velocity, after.velocity, 1e-8) << history.index() << " at " << t;
      EXPECT_NEAR(before.displacement, after.displacement, 1e-8) << history.index() << " at " << t;
    }
}

// One cycle of a sine acceleration leaves a displacement of T^2/(2 pi) and no velocity.
TEST(Motion, OneCycleOfAcceleration) {
  const double period = 0.25;
  const MotionFactors end = motion_at(MotionKind::acceleration, SineCycles{1 / period, 1, 0.5}, 2);
  EXPECT_NEAR(end.velocity, 0, 1e-16);
  EXPECT_NEAR(end.displacement, period * period / (2 * std::numbers::pi), 1e-16);
}

}  // namespace
}  // namespace dda
