// Ends that have failed, and ends that ride up as they slide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/open_close_models.h"

namespace dda {
namespace {

// Once failed, an end never has its peak again: not when it sticks, nor when it has been open.
TEST(ResidualStrength, StaysAfterShearFailure) {
  for (const EndStrength& strength : {weakening, dry_weakening}) {
    const double left = strength.residual_cohesion + 0.3 * 4;
    InterfaceState state = step_to(strength, start_with(strength.is_dry()), -0.04, 0.2);
    ASSERT_EQ(state.status[0], sliding);
    EXPECT_TRUE(state.residual[0]);
    EXPECT_NEAR(state.force(1), left, round_off);
    state = step_to(strength, state, -0.04, 0);
    ASSERT_EQ(state.status[0], locked);
    state = step_to(strength, state, 0.01, 0);
    ASSERT_EQ(state.status[0], open);
    state = step_to(strength, state, -0.04, 0.9 * left / shear_spring);
    EXPECT_EQ(state.status[0], locked);
    state = step_to(strength, state, -0.04, 1.1 * left / shear_spring);
    EXPECT_EQ(state.status[0], sliding);
    EXPECT_NEAR(state.force(1), left, round_off);
  }
}

TEST(ResidualStrength, ABondThatWasPulledApartHasNoPeakLeft) {
  InterfaceState state = step_to(weakening, start_with(false), 0.06, 0);
  ASSERT_EQ(state.status[0], open);
  state = step_to(weakening, state, -0.04, 0.126);
  EXPECT_NEAR(state.force(1), 0.6 + 0.3 * 4, round_off);
}

// Nothing was there to fail: surfaces that come apart and meet again have not been worn.
TEST(ResidualStrength, ADryEndThatOpensKeepsItsPeak) {
  InterfaceState state = step_to(dry_weakening, start_with(true), 0.06, 0);
  ASSERT_EQ(state.status[0], open);
  state = step_to(dry_weakening, state, -0.04, 0.049);
  EXPECT_EQ(state.status[0], locked);
  EXPECT_FALSE(state.residual[0]);
}

TEST(ResidualStrength, CohesionIsLeftOnlyWhereClosed) {
  EXPECT_EQ(weakening.capacity(0, true), 0);
  EXPECT_EQ(weakening.capacity(1, true), 0);
  EXPECT_NEAR(weakening.capacity(-1e-9, true), 0.6, 1e-9);
  EXPECT_NEAR(weakening.capacity(-4, false), 2, round_off);
}

// ---- Dilation: tangent 0.25 up to a slip of 0.04 m, friction 0.5.

const EndStrength rising{.friction = 0.5, .dilation = 0.25, .dilation_slip = 0.04};

TEST(Dilation, SlipLiftsAgainstAGivenGap) {
  const double slip = 0.02;
  // Held at its height, the end is pressed together by what it rides up.
  const double force = -normal_spring * (0.04 + 0.25 * slip);
  const InterfaceState state = step_to(rising, start_with(true), -0.04, slip - 0.5 * force / shear_spring);
  EXPECT_EQ(state.status[0], sliding);
  // The fixed point shrinks its error to 0.5 * 0.25 * 100/40 = 0.3 of it a pass; settle() makes eighty.
  EXPECT_NEAR(state.slip[0], slip, 1e-12);
  EXPECT_NEAR(state.dilation[0], 0.25 * slip, 1e-12);
  EXPECT_NEAR(state.force(0), force, 1e-9);
  EXPECT_NEAR(state.force(1), -0.5 * force, 1e-9);
  EXPECT_NEAR(state.gap(0) * normal_spring, state.force(0), 1e-9) << "the elastic part";
}

// Rides up whichever way it slips, down on the way back, and no further than the given slip.
TEST(Dilation, FollowsTheSlipFromTheStart) {
  for (const double side : {1.0, -1.0}) {
    InterfaceState state = start_with(true);
    double moved = 0;  // m, along the tangent
    for (const double target : {0.02, 0.2, 0.3, 0.06, -0.3}) {
      state = step_to(rising, state, -0.04 - state.dilation[0], state.gap(1) + side * (target - moved));
      moved = target;
      EXPECT_NEAR(state.dilation[0], 0.25 * std::min(std::abs(state.slip[0]), 0.04), 1e-12) << target;
    }
    EXPECT_LT(side * state.slip[0], -0.04);
  }
}

TEST(Dilation, AnOpenEndKeepsItsHeight) {
  InterfaceState state = step_to(rising, start_with(true), -0.04, 0.3);
  const double height = state.dilation[0];
  ASSERT_NEAR(height, 0.01, 1e-12);
  state = step_to(rising, state, 0.02 - height, state.gap(1));  // 0.02 m above the ground: the gap excludes the height
  EXPECT_EQ(state.status[0], open);
  EXPECT_EQ(state.dilation[0], height);
  state = step_to(rising, state, -0.005, 0);  // still above the ground, and pressed
  EXPECT_EQ(state.status[0], locked);
  EXPECT_NEAR(state.force(0), -0.005 * normal_spring, round_off);
}

}  // namespace
}  // namespace dda
