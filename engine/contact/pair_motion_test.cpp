#include "engine/contact/pair_motion.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

Vec6 increments(double u, double v, double turn, double xx, double yy, double xy) {
  Vec6 all;
  all << u, v, turn, xx, yy, xy;
  return all;
}

Box box(double left, double bottom, double right, double top) { return {Vec2(left, bottom), Vec2(right, top)}; }

TEST(PairMotion, DisplacesPointsToFirstOrder) {
  const Vec2 arm(2, 3);
  EXPECT_EQ(displacement_of(increments(1, -1, 0, 0, 0, 0), arm), Vec2(1, -1));
  EXPECT_EQ(displacement_of(increments(0, 0, 0.5, 0, 0, 0), arm), Vec2(-1.5, 1));
  EXPECT_EQ(displacement_of(increments(0, 0, 0, 0.5, 0.25, 0), arm), Vec2(1, 0.75));
  EXPECT_EQ(displacement_of(increments(0, 0, 0, 0, 0, 0.5), arm), Vec2(0.75, 0.5));
}

TEST(PairMotion, SliversThatGoWithTheirNeighbourDoNotMoveAgainstIt) {
  const Vec6 both = increments(0.3, 0.4, 0, 0, 0, 0);
  const MovingBox rock{box(0, 0, 1, 1), {0.5, 0.5}, both};
  const MovingBox sliver{box(1, 0, 1.001, 1), {1.0005, 0.5}, both};
  EXPECT_DOUBLE_EQ(largest_displacement(sliver), 0.5);
  EXPECT_EQ(relative_displacement(rock, sliver, 0.5), 0);
  const MovingBox still{sliver.box, sliver.centroid, Vec6::Zero()};
  EXPECT_DOUBLE_EQ(relative_displacement(rock, still, 0.5), 0.5);
}

TEST(PairMotion, BlocksOutOfEachOthersWayHaveNoPlaceInCommon) {
  const MovingBox here{box(0, 0, 1, 1), {0.5, 0.5}, increments(1, 0, 0, 0, 0, 0)};
  const MovingBox there{box(10, 0, 11, 1), {10.5, 0.5}, Vec6::Zero()};
  EXPECT_EQ(relative_displacement(here, there, 1), 0);
  EXPECT_EQ(relative_displacement(here, there, 5), 1);
}

}  // namespace
}  // namespace dda
