#include "engine/keyblocks/turning.h"

#include <gtest/gtest.h>

#include "engine/keyblocks/keyblocks_test_support.h"
#include "engine/keyblocks/non_negative.h"

namespace dda {
namespace {

// A block of width b and height h on an incline: the four regions of the chart (Goodman and Bray 1976; where it slides
// and topples at once: Bray and Goodman 1981). It topples where b/h < tan a and friction holds; where it slides, the
// force of friction turns it when b/h < tan f.
bool turns_on_incline(double slope, double friction, double width_over_height) {
  const double height = 2;
  const double width = width_over_height * height;
  const Vec2 along = unit(-slope);
  const Vec2 up(-along.y(), along.x());
  const Ring outline{{0, 0}, width * along, width * along + height * up, height * up};
  const RockBody body = body_with_joints(outline, {0}, {friction, 0});
  const Resultant acting{{0, -body.mass}, 0};
  return turns(body, acting, first_motion(body.joints, acting.force));
}

TEST(Turning, ChartOfABlockOnAnIncline) {
  for (double slope = 5; slope < 80; slope += 5) {
    for (double friction = 2.5; friction < 80; friction += 5) {
      const double border = std::tan(std::min(slope, friction) * degree);
      EXPECT_TRUE(turns_on_incline(slope * degree, friction * degree, 0.999 * border)) << slope << ' ' << friction;
      EXPECT_FALSE(turns_on_incline(slope * degree, friction * degree, 1.001 * border)) << slope << ' ' << friction;
    }
  }
}

// A plank on a ledge tips over its edge when its centroid lies beyond.
TEST(Turning, PlankOnALedge) {
  const auto tips = [](double ledge) {
    RockBody body = body_with_joints({{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}, {});
    body.joints.push_back(face_along({0, 0}, {ledge, 0}, {30 * degree, 0}));
    const Resultant acting{{0, -1}, 0};
    const FirstMotion motion = first_motion(body.joints, acting.force);
    EXPECT_EQ(motion.mode, Mode::stable);
    return turns(body, acting, motion);
  };
  EXPECT_TRUE(tips(1.99));
  EXPECT_FALSE(tips(2.01));
}

// A couple on a block that rests on the ground is balanced up to W b/2.
TEST(Turning, CoupleOnABlock) {
  const RockBody body = body_with_joints({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {0}, {30 * degree, 0});
  for (const double sign : {1.0, -1.0}) {
    const auto turned_by = [&](double moment) {
      const Resultant acting{{0, -10}, sign * moment};
      return turns(body, acting, first_motion(body.joints, acting.force));
    };
    EXPECT_FALSE(turned_by(9.99));
    EXPECT_TRUE(turned_by(10.01));
  }
}

TEST(Turning, WhatFallsDoesNotTurnByItself) {
  const RockBody body = body_with_joints({{-1, 0}, {1, 0}, {0, 2}}, {1, 2}, {});
  const Resultant acting{{0, -1}, 0};
  EXPECT_FALSE(turns(body, acting, first_motion(body.joints, acting.force)));
}

// Two directions span a sector; what is nearest to a target beyond it is on the nearer side, or the corner.
TEST(LeastLeft, IsTheDistanceFromWhatPositiveSharesSpan) {
  for (double opening = 10; opening < 180; opening += 10) {
    Eigen::MatrixXd sides(2, 2);
    sides << unit(0), unit(opening * degree);
    for (double angle = -175; angle <= 180; angle += 5) {
      const double beyond = angle < 0 ? std::min(-angle, 360 + angle - opening) : std::max(angle - opening, 0.0);
      const double expected = beyond >= 90 ? 1 : std::sin(beyond * degree);
      EXPECT_NEAR(least_left(sides, unit(angle * degree)), expected, 1e-12) << opening << ' ' << angle;
    }
  }
}

}  // namespace
}  // namespace dda
