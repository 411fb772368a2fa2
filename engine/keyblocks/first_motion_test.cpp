// Blocks whose motion and factor of safety can be written down by hand.
#include "engine/keyblocks/first_motion.h"

#include <gtest/gtest.h>

#include "engine/keyblocks/keyblocks_test_support.h"

namespace dda {
namespace {

constexpr double round_off = 1e-14;  // relative: a dozen operations
constexpr double weight = 1000;      // N per m of thickness
const Vec2 down(0, -weight);

void expect_way(const FirstMotion& motion, double angle) {
  EXPECT_NEAR((motion.direction - unit(angle)).norm(), 0, 10 * round_off);
}

// A block on an incline that falls to the right: tan f/tan a + c A/(W sin a).
TEST(FirstMotion, BlockOnAnIncline) {
  for (const double slope : {10 * degree, 35 * degree, 70 * degree}) {
    const double length = 2.5;
    const Strength strength{30 * degree, 120};
    const std::vector<JointFace> faces{face_along({0, 0}, length * unit(-slope), strength)};
    const FirstMotion motion = first_motion(faces, down);
    EXPECT_EQ(motion.mode, Mode::slides);
    expect_way(motion, -slope);
    const double expected = std::tan(30 * degree) / std::tan(slope) + 120 * length / (weight * std::sin(slope));
    EXPECT_NEAR(motion.factor_of_safety, expected, round_off * expected);
    EXPECT_EQ(motion.pressed, std::vector<int>{0});
  }
}

// The prism in a roof between joints at `left` and `right` degrees from upright that meet above it.
std::vector<JointFace> roof_prism(double left, double right, const Strength& strength) {
  return {face_along({2 * std::tan(right), -2}, {0, 0}, strength),
          face_along({0, 0}, {-2 * std::tan(left), -2}, strength)};
}

TEST(FirstMotion, PrismInARoofFalls) {
  const FirstMotion motion = first_motion(roof_prism(20 * degree, 35 * degree, {60 * degree, 1e6}), down);
  EXPECT_EQ(motion.mode, Mode::falls);
  EXPECT_EQ(motion.factor_of_safety, 0);  // it parts from both joints, whose cohesion holds nothing then
  expect_way(motion, -90 * degree);
}

// One joint leans over the prism by 50 degrees from upright, the other under it by 20: it slides on the latter.
TEST(FirstMotion, PrismBetweenJointsThatLeanAlikeSlides) {
  const FirstMotion motion = first_motion(roof_prism(50 * degree, -20 * degree, {35 * degree, 0}), down);
  EXPECT_EQ(motion.mode, Mode::slides);
  expect_way(motion, -(90 + 20) * degree);
  const double expected = std::tan(35 * degree) / std::tan(70 * degree);
  EXPECT_NEAR(motion.factor_of_safety, expected, round_off);
}

TEST(FirstMotion, WiderAboveIsKeyed) {
  // Corners from the left below: 2 m wide below, 4 m above; joints on both sides and above.
  const Ring outline{{-1, 0}, {1, 0}, {2, 2}, {-2, 2}};
  const RockBody body = body_with_joints(outline, {1, 2, 3}, {});
  EXPECT_FALSE(is_removable(body.joints));
  EXPECT_EQ(first_motion(body.joints, down).mode, Mode::keyed);
  EXPECT_TRUE(permitted_ways(body.joints).empty());
}

// A trapezoid in the left wall of an opening, which lies to its right. Its floor falls to the opening by 25 degrees,
// its ceiling by 10: it opens towards the opening and slides on the floor.
TEST(FirstMotion, TrapezoidInASideWall) {
  const double floor = 25 * degree;
  const double ceiling = 10 * degree;
  const Vec2 below = Vec2(0, 0);
  const Vec2 above = Vec2(0, 1);
  const std::vector<JointFace> faces{
      face_along(below, below + 2 / std::cos(floor) * unit(-floor), {20 * degree, 50}),
      face_along(above + 2 / std::cos(ceiling) * unit(-ceiling), above, {20 * degree, 50}),
      face_along(above, below, {20 * degree, 50})};
  const FirstMotion motion = first_motion(faces, down);
  EXPECT_EQ(motion.mode, Mode::slides);
  expect_way(motion, -floor);
  const double expected = std::tan(20 * degree) / std::tan(floor) +
                          50 * 2 / std::cos(floor) / (weight * std::sin(floor));  // of the floor alone: the rest opens
  EXPECT_NEAR(motion.factor_of_safety, expected, round_off * expected);
  const std::vector<Ways> ways = permitted_ways(faces);
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_NEAR(ways[0].from, -floor, round_off);
  EXPECT_NEAR(ways[0].to, -ceiling, round_off);
}

TEST(FirstMotion, TrapezoidThatNarrowsTowardsTheOpeningIsKeyed) {
  const std::vector<JointFace> faces{face_along({0, 0}, 2 * unit(-10 * degree), {}),
                                     face_along(Vec2(0, 1) + 2 * unit(-25 * degree), {0, 1}, {}),
                                     face_along({0, 1}, {0, 0}, {})};
  EXPECT_FALSE(is_removable(faces));
}

// Between parallel upright joints it grazes both on its way down, and both cohesions hold it.
TEST(FirstMotion, BetweenParallelJoints) {
  const auto between = [](double cohesion) {
    return std::vector<JointFace>{face_along({1, 0}, {1, 3}, {40 * degree, cohesion}),
                                  face_along({1, 3}, {0, 3}, {40 * degree, cohesion}),
                                  face_along({0, 3}, {0, 0}, {40 * degree, cohesion})};
  };
  const FirstMotion free = first_motion(between(0), down);
  EXPECT_EQ(free.mode, Mode::falls);
  EXPECT_EQ(free.factor_of_safety, 0);
  EXPECT_NEAR(first_motion(between(300), down).factor_of_safety, 2 * 3 * 300 / weight, round_off * 1.8);
  const std::vector<Ways> ways = permitted_ways(between(0));
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_EQ(ways[0].from, ways[0].to);
}

TEST(FirstMotion, BetweenTwoParallelJointsAloneThereAreTwoWays) {
  const std::vector<JointFace> faces{face_along({1, 0}, {1, 3}, {}), face_along({0, 3}, {0, 0}, {})};
  EXPECT_EQ(permitted_ways(faces).size(), 2U);
  EXPECT_EQ(first_motion(faces, {5, 0}).mode, Mode::stable);
}

// Half of a symmetric prism, at `alpha` from upright, pressed by the horizontal thrust H of the other half: at its
// limit W/2 = H tan(f - alpha) (Bray; Brady and Brown 1985).
TEST(FirstMotion, HalfARoofPrismUnderThrustHasBraysLimit) {
  const double thrust = 1e5;
  for (const auto& [alpha, friction] : {std::pair{15 * degree, 30 * degree}, std::pair{35 * degree, 55 * degree}}) {
    // The left abutment leans over the prism: its joint runs from the tip down to the left.
    const std::vector<JointFace> faces{face_along({0, 2}, Vec2(-2 * std::tan(alpha), 0), {friction, 0})};
    const double limit = thrust * std::tan(friction - alpha);
    const FirstMotion motion = first_motion(faces, {-thrust, -limit});
    EXPECT_NEAR(motion.factor_of_safety, 1, 10 * round_off);
    EXPECT_LT(first_motion(faces, {-thrust, -1.01 * limit}).factor_of_safety, 1);
  }
}

// A hook: an L whose inner corner holds a neighbour. The faces of its convex hull would let it fall.
TEST(FirstMotion, AHookIsKeyedByItsInnerFaces) {
  const Ring outline{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {0, 1}};
  // Free below; to the right and on top of the arm there is rock, and rock rests on its foot.
  EXPECT_TRUE(is_removable(body_with_joints(outline, {1, 2, 3, 4}, {}).joints));
  // A neighbour that reaches under the arm from the right holds it.
  const Ring hooked{{0, 0}, {1, 0}, {1, 1.5}, {3, 1.5}, {3, 2.5}, {0, 2.5}};
  EXPECT_TRUE(is_removable(body_with_joints(hooked, {1}, {}).joints));
  EXPECT_EQ(first_motion(body_with_joints(hooked, {1, 2}, {}).joints, down).mode, Mode::stable);
  EXPECT_FALSE(is_removable(body_with_joints(hooked, {1, 2, 4, 5}, {}).joints));
}

// An arrow that points up in a roof: its two inner faces lie on a wedge of rock below, its outer faces against rock.
TEST(FirstMotion, AnArrowRestsOnItsInnerFaces) {
  const Ring arrow{{-2, 0}, {0, 1}, {2, 0}, {0, 3}};
  EXPECT_EQ(first_motion(body_with_joints(arrow, {2, 3}, {}).joints, down).mode, Mode::falls);
  EXPECT_EQ(first_motion(body_with_joints(arrow, {0, 1}, {}).joints, down).mode, Mode::stable);
  EXPECT_FALSE(is_removable(body_with_joints(arrow, {0, 1, 2, 3}, {}).joints));
}

// Pressure is shared by length: a metre of 20 degrees, three of 40.
TEST(FirstMotion, FrictionOfTwoStretchesOfOneJoint) {
  const Vec2 way = unit(-30 * degree);
  const std::vector<JointFace> faces{face_along({0, 0}, way, {20 * degree, 0}),
                                     face_along(way, 4 * way, {40 * degree, 0})};
  const double mean = (std::tan(20 * degree) + 3 * std::tan(40 * degree)) / 4;
  EXPECT_NEAR(first_motion(faces, down).factor_of_safety, mean / std::tan(30 * degree), 10 * round_off);
}

TEST(FirstMotion, WithoutForceNothingMoves) {
  EXPECT_EQ(first_motion(roof_prism(0.3, 0.3, {}), Vec2::Zero()).mode, Mode::stable);
}

TEST(FirstMotion, WithoutNeighboursItFallsAllAround) {
  const FirstMotion motion = first_motion({}, {3, 4});
  EXPECT_EQ(motion.mode, Mode::falls);
  EXPECT_EQ(motion.factor_of_safety, 0);
  EXPECT_EQ(permitted_ways({}).size(), 1U);
}

}  // namespace
}  // namespace dda
