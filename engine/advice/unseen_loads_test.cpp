#include "engine/advice/unseen_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/advice/lattice_test_support.h"

namespace dda {
namespace {

double share_of_sine(double steps_in_period, double phase = 0) {
  return unseen_share([=](double t) { return std::sin(2 * std::numbers::pi * (t + phase)); }, 0, 40,
                      1 / steps_in_period, 1);
}

// A sine by straight lines between n values in a period, over all phases: the square of what is left is
// 1 - 2 (sin(a)/a)^2 + (2 + cos(2a))/3 with a = pi/n. Eight points a step and 40 periods leave 1 %.
TEST(UnseenLoads, SharesOfSinesAreThoseOfStraightLines) {
  for (const double steps : {3.1, 4.3, 8.7}) {
    const double a = std::numbers::pi / steps;
    const double square = 1 - 2 * std::pow(std::sin(a) / a, 2) + (2 + std::cos(2 * a)) / 3;
    EXPECT_NEAR(share_of_sine(steps) / std::sqrt(square), 1, 0.02) << steps;
  }
  EXPECT_NEAR(share_of_sine(1), 1, 1e-9);
  EXPECT_NEAR(share_of_sine(2), 1, 1e-9);
  EXPECT_EQ(unseen_share([](double) { return 0.0; }, 0, 1, 0.1, 1), 0);
}

Model pushed(const TimeFunction& history, double dt) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent));
  model.stages[0].dt = dt;
  model.stages[0].duration = 1;
  model.edge_loads.push_back({0, {0, 0.8}, {0, 0}, {1, 0}, history});
  finish_model(model);
  return model;
}

TEST(UnseenLoads, NamesWhatStepsPassOver) {
  const std::vector<std::string> found = unseen_loads(pushed(SineCycles{1000, INFINITY, 0}, 1e-3));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("a sine of 1000 Hz"), std::string::npos) << found[0];
  EXPECT_NE(found[0].find("miss 100 %"), std::string::npos) << found[0];
  EXPECT_EQ(unseen_loads(pushed(SineCycles{330, INFINITY, 0}, 1e-3)).size(), 1U);
}

// Looked at where it is, however long the stage and its steps are; and a second one elsewhere is not taken for it.
TEST(UnseenLoads, FindsPulsesFarShorterThanAStep) {
  const PiecewiseLinear blow{{0.301, 0.30101, 0.30102}, {0, 1, 0}};
  Model model = pushed(blow, 0.1);
  EXPECT_EQ(unseen_loads(model).size(), 1U);
  model.edge_loads.push_back(model.edge_loads.front());
  model.edge_loads.back().history = PiecewiseLinear{{0.801, 0.80101, 0.80102}, {0, 1, 0}};
  EXPECT_EQ(unseen_loads(model).size(), 2U);
}

TEST(UnseenLoads, SaysNothingOfWhatIsSeen) {
  EXPECT_TRUE(unseen_loads(pushed(SineCycles{100, 3, 0}, 1e-3)).empty());
  EXPECT_TRUE(unseen_loads(pushed(Constant{}, 1e-3)).empty());
  EXPECT_TRUE(unseen_loads(pushed(ExponentialDecay{0.02, 0.1, 0}, 1e-3)).empty());  // a jump lies between two steps
  Model still = pushed(SineCycles{1000, INFINITY, 0}, 1e-3);
  still.stages[0].integrator = static_integrator();
  EXPECT_TRUE(unseen_loads(still).empty());
}

TEST(UnseenLoads, LooksAtMotionsAndSaysItOnceForMany) {
  Model model = pushed(Constant{}, 1e-3);
  for (const double y : {0.0, 0.8}) {
    PointSupport support;
    support.block = 0;
    support.point = {0, y};
    support.stiffness = 1e9;
    support.amplitude = {1e-3, 0};
    support.kind = MotionKind::velocity;
    support.history = SineCycles{1000, INFINITY, 0};
    model.supports.push_back(support);
  }
  EXPECT_EQ(unseen_loads(model).size(), 1U);
}

}  // namespace
}  // namespace dda
