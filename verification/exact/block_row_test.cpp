#include "verification/exact/block_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace exact {
namespace {

BlockRow row_of(std::vector<double> velocity, double gap, double spring_over_young) {
  BlockRow row;
  row.mass = 2600;
  row.length = 1;
  row.axial_stiffness = 5e9;
  row.spring = 2 * spring_over_young * row.axial_stiffness;
  row.gaps.assign(velocity.size() - 1, gap);
  row.velocity = std::move(velocity);
  return row;
}

TEST(BlockRow, ConservesMomentumAndEnergy) {
  const BlockRow row = row_of({1, 0, -0.3, 0.2}, 0.01, 0.1);
  const BlockRowState after = move_block_row(row, 0.3);
  const double momentum = std::accumulate(after.velocity.begin(), after.velocity.end(), 0.0);
  EXPECT_NEAR(momentum, 0.9, 1e-12);
  double energy = after.vibration / (row.mass / 2);
  for (const double velocity : after.velocity) energy += velocity * velocity;
  EXPECT_NEAR(energy, 1.13, 1e-9);
}

// Stiff blocks: half a swing of m/2 on the spring, and the velocities are exchanged.
TEST(BlockRow, TwoStiffBlocksExchangeTheirVelocities) {
  const BlockRow row = row_of({1, 0}, 0, 1e-6);
  const double contact = std::numbers::pi * std::sqrt(row.mass / (2 * row.spring));
  const BlockRowState half = move_block_row(row, contact / 2);
  EXPECT_NEAR(half.velocity[0], 0.5, 1e-6);
  EXPECT_NEAR(half.position[0] - half.position[1], std::sqrt(row.mass / (2 * row.spring)), 1e-6 * half.position[0]);
  const BlockRowState after = move_block_row(row, 1.01 * contact);
  EXPECT_NEAR(after.velocity[0], 0, 1e-6);
  EXPECT_NEAR(after.velocity[1], 1, 1e-6);
}

// Two blocks that meet head on, in closed form: both contacts of the pair act as one spring, two modes.
TEST(BlockRow, HeadOnImpactOfSoftBlocks) {
  BlockRow row = row_of({1, -1}, 0, 0.5);
  const double k = row.spring;
  // Symmetric: u = -u2, e = e2; gap = -2 u - e: two unknowns in closed form, over a quarter of the slower period.
  const double m = row.mass, s = row.mass / 12, a = row.axial_stiffness;
  const double trace = 2 * k / m + (k / 2 + a) / s;
  const double determinant = 2 * k / m * (k / 2 + a) / s - k / m * k / s;
  const double slow = std::sqrt((trace - std::sqrt(trace * trace - 4 * determinant)) / 2);
  const double fast = std::sqrt((trace + std::sqrt(trace * trace - 4 * determinant)) / 2);
  const double end = 0.25 * 2 * std::numbers::pi / slow;
  // u'' = -(2 k/m) u - (k/m) e from u' = 1, e = 0: u = A sin(slow t) + B sin(fast t), u'''(0) = -2 k/m.
  const double share = (2 * k / m - fast * fast) / (slow * slow - fast * fast);
  const double expected = share / slow * std::sin(slow * end) + (1 - share) / fast * std::sin(fast * end);
  EXPECT_NEAR(move_block_row(row, end).position[0], expected, 1e-9 * expected);
}

}  // namespace
}  // namespace exact
