#include "engine/model/energy_release.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

// Strain energy went into motion, but for `lost`.
EnergyRelease of_motion(double released, double lost) {
  EnergyLedger before;
  before.strain = 1e9;
  before.initial.strain = 1e9;
  EnergyLedger after = before;
  after.strain -= released;
  after.kinetic = released - lost;
  return energy_release(before, after);
}

TEST(EnergyRelease, DiffersByWhatTheBalanceMisses) {
  EXPECT_EQ(of_motion(1e8, 0).relative_difference(), 0);
  EXPECT_NEAR(of_motion(1e8, 1).relative_difference(), 1e-8, 1e-15);
  EXPECT_NEAR(of_motion(2e4, 2e-5).relative_difference(), 1e-9, 1e-11);  // 1e-9 is seen down to 1.4e-5 of the largest
  EXPECT_NEAR(of_motion(1, 0.5).relative_difference(), 0.5, 1e-7);       // and where little is released, what is wrong
}

// Rock at rest: sums of 1e9 J that differ in their last digits, and what is left of motion. It was -1 or 1.
TEST(EnergyRelease, HasNoDifferenceInRoundOff) {
  EnergyLedger before;
  before.strain = 1e9;
  EnergyLedger after = before;
  after.kinetic = 3e-15;
  EXPECT_EQ(energy_release(before, after).relative_difference(), 0);
  after.strain += 1.2e-7;
  EXPECT_EQ(energy_release(before, after).relative_difference(), 0);
  after.strain += 1e-3;
  EXPECT_NEAR(energy_release(before, after).relative_difference(), -1, 1e-9);
  EXPECT_EQ(energy_release(EnergyLedger(), EnergyLedger()).relative_difference(), 0);
}

// Each step rounds, so a stage of 2,613 steps at rest differed by 325 roundings of its 59,539 J, and seemed to miss
// 1.2e-3 of the 3.6e-6 J that were entered in it.
TEST(EnergyRelease, AllowsForWhatManyStepsRound) {
  EnergyLedger before;
  before.strain = 59539;
  EnergyLedger after = before;
  after.external_work = 3.58e-6;
  after.strain += 3.58e-6 - 4.3e-9;
  EXPECT_NEAR(energy_release(before, after).relative_difference(), 1.2e-3, 1e-4);
  EXPECT_EQ(energy_release(before, after, 2613).relative_difference(), 0);
  after.strain -= 1e-7;  // what is wrong is seen
  EXPECT_NEAR(energy_release(before, after, 2613).relative_difference(), 0.029, 1e-3);
}

}  // namespace
}  // namespace dda
