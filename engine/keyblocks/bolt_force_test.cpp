#include "engine/keyblocks/bolt_force.h"

#include <gtest/gtest.h>

#include "engine/keyblocks/first_motion.h"
#include "engine/keyblocks/keyblocks_test_support.h"

namespace dda {
namespace {

constexpr double round_off = 1e-12;  // relative
constexpr double weight = 1000;      // N per m of thickness
const Vec2 down(0, -weight);
constexpr double slope = 40 * degree;

std::vector<JointFace> incline(const Strength& strength) { return {face_along({0, 0}, 2 * unit(-slope), strength)}; }

// A bolt along the slope takes from the drive, one square to it adds to the pressure (active bolts).
TEST(BoltForce, OfABlockOnAnIncline) {
  const Strength strength{30 * degree, 20};
  const double cohesion = 2 * strength.cohesion;
  const double friction = std::tan(strength.friction_angle);
  for (const double wanted : {1.0, 1.5, 3.0}) {
    const double resistance = weight * std::cos(slope) * friction + cohesion;
    const double drive = weight * std::sin(slope);
    const auto along = bolt_force(incline(strength), down, -unit(-slope), wanted);
    ASSERT_TRUE(along);
    EXPECT_NEAR(*along, drive - resistance / wanted, round_off * weight);
    const auto square = bolt_force(incline(strength), down, unit(-slope - 90 * degree), wanted);
    ASSERT_TRUE(square);
    EXPECT_NEAR(*square, (wanted * drive - resistance) / friction, round_off * weight);
    // The best direction lies between: atan(tan f/F) from the slope towards its inside.
    const double turned = std::atan(friction / wanted);
    const Vec2 least = least_bolt_force(incline(strength), down, wanted);
    EXPECT_NEAR(least.norm(), (wanted * drive - resistance) / std::hypot(wanted, friction), round_off * weight);
    EXPECT_NEAR((least.normalized() - unit(180 * degree - slope + turned)).norm(), 0, round_off);
  }
}

TEST(BoltForce, NoneWhereItIsSafe) {
  EXPECT_EQ(bolt_force(incline({60 * degree, 0}), down, Vec2::UnitY(), 1.5), 0);
  EXPECT_EQ(least_bolt_force(incline({60 * degree, 0}), down, 1.5), Vec2::Zero());
}

TEST(BoltForce, NothingWhereTheDirectionDoesNotHelp) {
  EXPECT_EQ(bolt_force(incline({30 * degree, 0}), down, unit(-slope), 1.5), std::nullopt);
}

// A prism between joints 20 degrees from upright: upwards its whole weight; cheaper is to press it onto one joint.
TEST(BoltForce, OfAPrismInARoof) {
  const double alpha = 20 * degree;
  const double friction = 50 * degree;
  const double half = 2 * std::tan(alpha);
  const std::vector<JointFace> faces{face_along({half, -2}, {0, 0}, {friction, 0}),
                                     face_along({0, 0}, {-half, -2}, {friction, 0})};
  const auto upwards = bolt_force(faces, down, Vec2::UnitY(), 1.5);
  ASSERT_TRUE(upwards);
  EXPECT_NEAR(*upwards, weight, round_off * weight);
  const double mobilised = std::atan(std::tan(friction) / 1.5);
  EXPECT_NEAR(least_bolt_force(faces, down, 1.5).norm(), weight * std::cos(mobilised - alpha), round_off * weight);
}

// Half of Bray's prism: the thrust that gives the wanted factor is W/2 / tan(atan(tan f/F) - alpha).
TEST(BoltForce, ThrustOnHalfARoofPrism) {
  const double alpha = 15 * degree;
  const std::vector<JointFace> faces{face_along({0, 2}, Vec2(-2 * std::tan(alpha), 0), {40 * degree, 0})};
  for (const double wanted : {1.0, 1.3, 2.0}) {
    const double mobilised = std::atan(std::tan(40 * degree) / wanted);
    const auto thrust = bolt_force(faces, down, -Vec2::UnitX(), wanted);
    ASSERT_TRUE(thrust);
    EXPECT_NEAR(*thrust, weight / std::tan(mobilised - alpha), 10 * round_off * weight);
  }
}

// Between parallel joints cohesion bears 2 c L/F of the weight.
TEST(BoltForce, BetweenParallelJoints) {
  const Strength strength{0, 100};
  const std::vector<JointFace> faces{face_along({1, 0}, {1, 3}, strength), face_along({0, 3}, {0, 0}, strength)};
  const auto upwards = bolt_force(faces, down, Vec2::UnitY(), 1.5);
  ASSERT_TRUE(upwards);
  EXPECT_NEAR(*upwards, weight - 2 * 3 * 100 / 1.5, round_off * weight);
}

}  // namespace
}  // namespace dda
