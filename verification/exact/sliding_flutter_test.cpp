#include "verification/exact/sliding_flutter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exact {
namespace {

const SlidingBlock cube{1, 1, 2600, 5e9, 0.2, 5e10};

TEST(SlidingFlutter, NoneWithoutFriction) { EXPECT_LT(fastest_growth(cube, 0).real(), 1e-3); }

TEST(SlidingFlutter, SetsInWithFriction) {
  EXPECT_LT(fastest_growth(cube, 0.5).real(), 1e-3);
  EXPECT_GT(fastest_growth(cube, 0.6).real(), 100);
  EXPECT_GT(fastest_growth(cube, 0.7).real(), fastest_growth(cube, 0.6).real());
}

// In proportion to sqrt(stiffness/mass) and to one over the size.
TEST(SlidingFlutter, Scales) {
  const std::complex<double> rate = fastest_growth(cube, 0.7);
  SlidingBlock other = cube;
  other.young *= 4;
  other.normal_spring *= 4;
  EXPECT_NEAR(std::abs(fastest_growth(other, 0.7) / rate - 2.0), 0, 1e-9);
  other = cube;
  other.width = other.height = 2;
  EXPECT_NEAR(std::abs(fastest_growth(other, 0.7) / rate - 0.5), 0, 1e-9);
}

// It takes an elastic block: a rigid one feels the normal motion of its corners in its rotation, but not the other way
// round.
TEST(SlidingFlutter, NoneForARigidBlock) {
  SlidingBlock rigid = cube;
  rigid.height = 0.7;  // a square's two vibrations of strain have one frequency, and any friction couples them
  rigid.normal_spring = 1e-4 * rigid.young;
  EXPECT_LT(fastest_growth(rigid, 0.7).real(), 1e-6 * std::sqrt(2 * rigid.normal_spring / 2600));
}

// That double frequency, omega^2 = 24 G/(rho a^2), grows in proportion to the springs.
TEST(SlidingFlutter, ASquareOnSoftSpringsAtAnyFriction) {
  SlidingBlock soft = cube;
  soft.normal_spring = 1e-4 * soft.young;
  const std::complex<double> rate = fastest_growth(soft, 0.1);
  const double shear = soft.young / (2 * (1 + soft.poisson));
  EXPECT_NEAR(rate.imag() / std::sqrt(24 * shear / soft.density), 1, 1e-3);
  EXPECT_GT(rate.real(), 0);
  soft.normal_spring *= 2;
  EXPECT_NEAR(fastest_growth(soft, 0.1).real() / rate.real(), 2, 1e-3);
}

}  // namespace
}  // namespace exact
