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

// A bolt along the slope takes from the drive, one square to it adds to the pressure. Along the slope joints of less
// strength ask for drive - resistance/F, and a larger weight for F (drive - friction) - cohesion.
TEST(BoltForce, OfABlockOnAnIncline) {
  const Strength strength{30 * degree, 20};
  const double cohesion = 2 * strength.cohesion;
  const double friction = std::tan(strength.friction_angle);
  const double drive = weight * std::sin(slope);
  const double held = weight * std::cos(slope) * friction;
  for (const double wanted : {1.0, 1.5, 3.0, 5.0}) {
    const auto along = bolt_force(incline(strength), down, -unit(-slope), wanted);
    ASSERT_TRUE(along);
    const double expected = std::max(drive - (held + cohesion) / wanted, wanted * (drive - held) - cohesion);
    EXPECT_NEAR(*along, expected, round_off * weight);
    const auto square = bolt_force(incline(strength), down, unit(-slope - 90 * degree), wanted);
    ASSERT_TRUE(square);
    EXPECT_NEAR(*square, (wanted * drive - held - cohesion) / friction, 2 * round_off * weight);
  }
}

// The best direction lies between: atan(tan f/F) from the slope towards its inside.
TEST(BoltForce, LeastOnAnIncline) {
  const double friction = std::tan(30 * degree);
  for (const double wanted : {1.0, 1.5, 2.0}) {
    const double over = wanted * std::sin(slope) - std::cos(slope) * friction;
    const Vec2 least = least_bolt_force(incline({30 * degree, 0}), down, wanted);
    EXPECT_NEAR(least.norm(), weight * over / std::hypot(wanted, friction), round_off * weight);
    const double turned = std::atan(friction / wanted);
    EXPECT_NEAR((least.normalized() - unit(180 * degree - slope + turned)).norm(), 0, round_off);
  }
}

// Upright bolts take pressure and drive in equal shares: up to the whole weight the factor of joints without cohesion
// is what it was, and there it is infinite. What decides is how much more than the weight they can carry.
TEST(BoltForce, UprightOnAnIncline) {
  for (const double wanted : {1.0, 1.5, 3.0}) {
    const auto upwards = bolt_force(incline({20 * degree, 0}), down, Vec2::UnitY(), wanted);
    ASSERT_TRUE(upwards);
    EXPECT_NEAR(*upwards, wanted * weight, round_off * wanted * weight);
  }
}

// What falls freely is held by bolts alone, and their factor is force over weight, whatever the friction of its joints.
// Between joints a from upright, bolts that are turned by t press it on one of them. That holds with the angle of
// friction f, and the polygon of forces has B = W cos(a - f) / cos(a - f + t).
TEST(BoltForce, OfAWedgeThatFalls) {
  const double alpha = 30 * degree;
  const double half = 2 * std::tan(alpha);
  for (const double friction : {0.0, 10 * degree, 25 * degree}) {
    const std::vector<JointFace> faces{face_along({half, -2}, {0, 0}, {friction, 0}),
                                       face_along({0, 0}, {-half, -2}, {friction, 0})};
    for (const double wanted : {1.0, 1.5, 2.0, 4.0}) {
      const auto upwards = bolt_force(faces, down, Vec2::UnitY(), wanted);
      ASSERT_TRUE(upwards);
      EXPECT_NEAR(*upwards, wanted * weight, round_off * wanted * weight);
      for (const double turned : {-20 * degree, 12 * degree}) {
        // Against the joint that it is pressed on: the smaller friction under the weight, or all under F times as much.
        const double mobilised = std::atan(std::tan(friction) / wanted);
        const auto needed = [&](double f) { return std::cos(alpha - f) / std::cos(alpha - f + std::abs(turned)); };
        const auto force = bolt_force(faces, down, unit(90 * degree + turned), wanted);
        ASSERT_TRUE(force);
        EXPECT_NEAR(*force, weight * std::max(needed(mobilised), wanted * needed(friction)),
                    round_off * wanted * weight);
      }
    }
  }
}

TEST(BoltForce, NoneWhereItIsSafe) {
  EXPECT_EQ(bolt_force(incline({60 * degree, 0}), down, Vec2::UnitY(), 1.5), 0);
  EXPECT_EQ(least_bolt_force(incline({60 * degree, 0}), down, 1.5), Vec2::Zero());
}

TEST(BoltForce, NothingWhereTheDirectionDoesNotHelp) {
  EXPECT_EQ(bolt_force(incline({30 * degree, 0}), down, unit(-slope), 1.5), std::nullopt);
}

// A prism between joints 20 degrees from upright: upwards F times its weight; cheaper is to press it onto one joint.
TEST(BoltForce, OfAPrismInARoof) {
  const double alpha = 20 * degree;
  const double friction = 50 * degree;
  const double half = 2 * std::tan(alpha);
  const std::vector<JointFace> faces{face_along({half, -2}, {0, 0}, {friction, 0}),
                                     face_along({0, 0}, {-half, -2}, {friction, 0})};
  const auto upwards = bolt_force(faces, down, Vec2::UnitY(), 1.5);
  ASSERT_TRUE(upwards);
  EXPECT_NEAR(*upwards, 1.5 * weight, 2 * round_off * weight);
  EXPECT_NEAR(least_bolt_force(faces, down, 1.5).norm(), 1.5 * weight * std::cos(friction - alpha),
              2 * round_off * weight);
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

// Between parallel joints cohesion bears 2 c L of F times the weight.
TEST(BoltForce, BetweenParallelJoints) {
  const Strength strength{0, 100};
  const std::vector<JointFace> faces{face_along({1, 0}, {1, 3}, strength), face_along({0, 3}, {0, 0}, strength)};
  const auto upwards = bolt_force(faces, down, Vec2::UnitY(), 1.5);
  ASSERT_TRUE(upwards);
  EXPECT_NEAR(*upwards, 1.5 * weight - 2 * 3 * 100, 2 * round_off * weight);
}

}  // namespace
}  // namespace dda
