#include "verification/exact/arch_thrust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace exact {
namespace {

TEST(ArchThrust, ManyVoussoirsNeedMilankovitchsThickness) {
  EXPECT_NEAR(least_thickness(1000), 0.1075, 5e-5);
  EXPECT_NEAR(least_thickness(1001), least_thickness(1000), 1e-6);
}

// Fewer joints leave fewer places for hinges.
TEST(ArchThrust, FewVoussoirsNeedLess) {
  EXPECT_LT(least_thickness(5), least_thickness(9));
  EXPECT_LT(least_thickness(15), least_thickness(1000));
  EXPECT_GT(least_thickness(15), 0.09);
}

// Four voussoirs, two on each side: every thrust and height of a fine grid, moments about the six corners written out.
TEST(ArchThrust, FourVoussoirsByHand) {
  const auto stands = [](double t) {
    const double inner = 1 - t / 2;
    const double outer = 1 + t / 2;
    const double eighth = std::numbers::pi / 8;
    const double radius =
        std::cos(eighth) * 2 / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
    const double upper = radius * std::sin(eighth);
    const double lower = radius * std::cos(eighth);
    const double half = std::sqrt(0.5);
    for (double thrust = 0.01; thrust < 4; thrust += 1e-4) {
      const double low = std::max({thrust * inner, half * inner * (thrust + 1) - upper, 2 * inner - upper - lower});
      const double high = std::min({thrust * outer, half * outer * (thrust + 1) - upper, 2 * outer - upper - lower});
      if (low <= high) return true;
    }
    return false;
  };
  const double least = least_thickness(4);
  EXPECT_GT(least, 0.01);
  EXPECT_TRUE(stands(least * 1.01));
  EXPECT_FALSE(stands(least * 0.99));
}

// With three the line of thrust has a joint for each of its two unknowns.
TEST(ArchThrust, ThreeVoussoirsStandHoweverThin) { EXPECT_LT(least_thickness(3), 1e-12); }

TEST(ArchThrust, FrictionNeededIsModest) {
  for (const int voussoirs : {8, 15, 30}) {
    const double needed = needed_friction({voussoirs, least_thickness(voussoirs)});
    EXPECT_GT(needed, 0.2) << voussoirs;
    EXPECT_LT(needed, std::tan(35 * std::numbers::pi / 180)) << voussoirs;
  }
}

}  // namespace
}  // namespace exact
