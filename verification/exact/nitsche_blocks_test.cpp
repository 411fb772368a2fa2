#include "verification/exact/nitsche_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

const NitscheBlocks first{1, true, 4, 0.1, 0.25};
const NitscheBlocks second{2, false, 4, 0, 0.25};

double order(const NitscheBlocks& blocks, double blocks_per_wavelength) {
  return std::log2(worst_speed_error(blocks, blocks_per_wavelength) /
                   worst_speed_error(blocks, 2 * blocks_per_wavelength));
}

TEST(NitscheBlocks, ConvergeWithTwiceTheirOrder) {
  EXPECT_NEAR(order(first, 20), 2, 0.02);
  EXPECT_NEAR(order(second, 10), 4, 0.1);
}

// Along the sides (2 pi/40)^2/24 is left of first-order blocks whatever the penalty; at 45 degrees, of mid-edge joints
// without stabilisation, nothing of that order.
TEST(NitscheBlocks, FirstOrderHasTheDispersionOfTheChain) {
  const double leading = std::pow(2 * std::numbers::pi / 40, 2) / 24;
  for (const double penalty : {2.0, 4.0, 8.0}) {
    const SpeedErrors errors = speed_errors({1, true, penalty, 0, 0.25}, 40, 0);
    EXPECT_NEAR(errors.p / leading, 1, 0.02);
    EXPECT_NEAR(errors.s / leading, 1, 0.02);
    EXPECT_LT(std::abs(speed_errors({1, true, penalty, 0, 0.25}, 40, 45).s), 0.01 * leading);
  }
}

// An independent prototype printed, in per cent, for whole edges with a penalty of 2 E: .39, .35, .41, 1.1.
TEST(NitscheBlocks, WholeEdgesAreAnIndependentPrototypes) {
  const NitscheBlocks whole{1, false, 2 * (1 - 0.333 * 0.333), 0, 0.333};
  EXPECT_NEAR(100 * speed_errors(whole, 20, 0).p, 0.39, 0.006);
  EXPECT_NEAR(100 * speed_errors(whole, 20, 45).p, 0.35, 0.006);
  EXPECT_NEAR(100 * speed_errors(whole, 20, 0).s, 0.41, 0.006);
  EXPECT_NEAR(100 * speed_errors(whole, 20, 45).s, 1.1, 0.06);
}

// Turned by 90 degrees a square mesh is the same.
TEST(NitscheBlocks, HaveTheSymmetryOfTheSquare) {
  for (const NitscheBlocks& blocks : {first, second}) {
    const SpeedErrors here = speed_errors(blocks, 8, 20), there = speed_errors(blocks, 8, 70);
    EXPECT_NEAR(here.s, there.s, 1e-10);
    EXPECT_NEAR(here.p, there.p, 1e-10);
  }
}

TEST(NitscheBlocks, NeedsAPenalty) {
  EXPECT_THROW((void)speed_errors({1, true, 0.5, 0.1, 0.25}, 20, 0), std::invalid_argument);
  EXPECT_THROW((void)speed_errors({2, false, 0.5, 0, 0.25}, 20, 0), std::invalid_argument);
}

// The figures of docs/adr: blocks in a wavelength for a speed error in all directions, and so blocks in a square.
TEST(NitscheBlocks, NeededForAnError) {
  EXPECT_NEAR(blocks_needed(first, 1e-2), 12.8, 0.1);
  EXPECT_NEAR(blocks_needed(first, 1e-3), 40.7, 0.3);
  EXPECT_NEAR(blocks_needed(second, 1e-2), 4.3, 0.1);
  EXPECT_NEAR(blocks_needed(second, 1e-3), 7.9, 0.1);
}

}  // namespace
}  // namespace exact
