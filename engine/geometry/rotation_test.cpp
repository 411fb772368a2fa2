#include "engine/geometry/rotation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "engine/geometry/random_polygon.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double round_off = 2e-15;  // entries of magnitude up to 2, each rounded a few times at 1.1e-16

Mat2 tensor(const Vec3& components) {
  Mat2 matrix;
  matrix << components[0], components[2], components[2], components[1];
  return matrix;
}

TEST(Rotation, TurnsCounterClockwise) {
  EXPECT_LE((rotation(pi / 2) * Vec2(1, 0) - Vec2(0, 1)).norm(), round_off);
  EXPECT_LE((rotation(pi / 6) * Vec2(2, 0) - Vec2(std::sqrt(3), 1)).norm(), round_off);
}

RC_GTEST_PROP(RotationProperty, KeepsLengthsAndAdds, ()) {
  const double a = random::number(-3.2, 3.2);
  const double b = random::number(-3.2, 3.2);
  RC_ASSERT((rotation(a).transpose() * rotation(a) - Mat2::Identity()).norm() <= round_off);
  RC_ASSERT((rotation(a) * rotation(b) - rotation(a + b)).norm() <= round_off);
}

TEST(DeformationIncrement, StretchesHalfwayThroughTheTurn) {
  Vec6 dofs;
  dofs << 7, 8, pi, 0.5, 0, 0;
  Mat2 expected;
  expected << -1, 0, 0, -1.625;  // what points along y at first points along x halfway: 1 + 0.5 + 0.5^2/2
  EXPECT_LE((deformation_increment(dofs) - expected).norm(), round_off);
}

TEST(DeformationIncrement, TakesTheEngineeringShearStrain) {
  Vec6 dofs;
  dofs << 0, 0, 0, 0.25, -0.125, 0.5;
  Mat2 expected;
  expected << 1.25 + 0.0625, 0.25 + 0.015625, 0.25 + 0.015625, 0.875 + 0.0390625;  // I + E + E^2/2
  EXPECT_EQ(deformation_increment(dofs), expected);
}

TEST(DeformationIncrement, AThousandLargeTurnsKeepTheArea) {
  Vec6 dofs = Vec6::Zero();
  dofs[2] = 0.1;
  Mat2 total = Mat2::Identity();
  for (int i = 0; i < 1000; ++i) total = deformation_increment(dofs) * total;
  // Each step adds a few roundings of 1.1e-16; the first-order update would grow the area by 1.01^1000, that is 2e4.
  EXPECT_NEAR(cross(total.col(0), total.col(1)), 1, 1000 * round_off);
}

Mat2 gradient_of(const Vec6& dofs) {
  Mat2 gradient;
  gradient << dofs[3], dofs[5] / 2 - dofs[2], dofs[5] / 2 + dofs[2], dofs[4];
  return gradient;
}

// The next terms are at most (|r0| + |E|)^3/6 with |E| at most 1.5 `size`.
RC_GTEST_PROP(DeformationIncrementProperty, ToSecondOrderIsTheExponentialOfTheGradient, ()) {
  constexpr double size = 1e-3;
  Vec6 dofs;
  for (double& value : dofs) value = random::number(-size, size);
  const Mat2 gradient = gradient_of(dofs);
  const Mat2 exponential = Mat2::Identity() + gradient + gradient * gradient / 2;
  RC_ASSERT((deformation_increment(dofs) - exponential).norm() <= 4 * size * size * size);
}

// Shear as of a deck of cards: lengths along x stay, so does the area.
TEST(DeformationIncrement, SimpleShearKeepsLengthsAlongItAndTheArea) {
  constexpr double shear = 1e-3;
  Vec6 dofs = Vec6::Zero();
  dofs[2] = -shear / 2;
  dofs[5] = shear;
  EXPECT_LE((deformation_increment(dofs) - (Mat2() << 1, shear, 0, 1).finished()).norm(), shear * shear * shear);
}

RC_GTEST_PROP(DeformationIncrementProperty, AStepBackUndoesAStep, ()) {
  constexpr double size = 1e-2;
  Vec6 dofs;
  for (double& value : dofs) value = random::number(-size, size);
  const Mat2 there_and_back = deformation_increment(-dofs) * deformation_increment(dofs);
  // (I + E + E^2/2)(I - E + E^2/2) = I + E^4/4, and E stretches by at most 1.5 `size`.
  RC_ASSERT((there_and_back - Mat2::Identity()).norm() <= 2 * size * size * size * size + round_off);
}

RC_GTEST_PROP(DeformationIncrementProperty, ToFirstOrderIsTheDisplacementField, ()) {
  Vec6 dofs;
  for (double& value : dofs) value = random::number(-1, 1) * 1e-5;
  const Vec2 offset = random::point(2);
  const Vec2 moved = dofs.head<2>() + deformation_increment(dofs) * offset;
  // The neglected terms are products of two of r0, ex, ey, gxy, each at most 1e-5, times the offset of at most 2.83 m.
  RC_ASSERT((moved - offset - displacement_rows(offset) * dofs).norm() <= 3 * 2.83e-10);
}

RC_GTEST_PROP(RotateStressProperty, IsTheTensorRule, ()) {
  const Vec3 stress(random::number(-1, 1), random::number(-1, 1), random::number(-1, 1));
  const double angle = random::number(-3.2, 3.2);
  const Mat2 expected = rotation(angle) * tensor(stress) * rotation(angle).transpose();
  RC_ASSERT((tensor(rotate_stress(stress, angle)) - expected).norm() <= round_off);
}

TEST(RotateStress, UniaxialStressTurnsWithTheBody) {
  EXPECT_LE((rotate_stress({1, 0, 0}, pi / 2) - Vec3(0, 1, 0)).norm(), round_off);
  EXPECT_LE((rotate_stress({1, 0, 0}, pi / 4) - Vec3(0.5, 0.5, 0.5)).norm(), round_off);
}

}  // namespace
}  // namespace dda
