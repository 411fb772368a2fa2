#include "verification/exact/toppling_slope.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exact {
namespace {

TEST(TopplingSlope, GoodmanAndBraysExample) {
  const TopplingSlope slope = goodman_bray_slope();
  EXPECT_EQ(slope.height(10), 40);
  EXPECT_EQ(slope.height(16), 4);
  // The published coefficient is 0.7855, with these forces (kN) on columns 12, 9 and 6.
  EXPECT_NEAR(limiting_friction(slope), 0.7855, 5e-5);
  const std::vector<double> forces = column_forces(slope, 0.7855);
  EXPECT_NEAR(forces[12], 292.5, 0.05);
  EXPECT_NEAR(forces[9], 2826.7, 0.05);
  EXPECT_NEAR(forces[6], 4837.0, 0.05);
  EXPECT_EQ(forces[13], 0);  // the three uppermost stand by themselves
  // Columns 13 to 4 topple, 3 to 1 slide.
  EXPECT_NEAR(forces[2] - forces[3], -25 * 12 * 10 * (std::cos(slope.dip) * 0.7855 - 0.5) / (1 - 0.7855 * 0.7855),
              1e-9);
  EXPECT_GT(forces[3] - forces[4], -25 * 16 * 10 * (std::cos(slope.dip) * 0.7855 - 0.5) / (1 - 0.7855 * 0.7855) + 1);
}

// A lone column: it topples when it is higher than width/tan(psi), held by a force at the step's height.
TEST(TopplingSlope, LoneColumn) {
  TopplingSlope slope = goodman_bray_slope();
  slope.columns = slope.crest = 1;
  slope.lower_step = 21;
  EXPECT_EQ(slope.height(1), 20);
  slope.lower_step = 5;
  slope.base_step = -15;  // 20 high, held 15 above its base
  const double weight = 25 * 20 * 10;
  const double moment = weight / 2 * (20 * 0.5 - 10 * std::cos(slope.dip));
  EXPECT_NEAR(column_forces(slope, 0.9).front(), moment / 15, 1e-9);
}

}  // namespace
}  // namespace exact
