#include "engine/advice/idle_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace dda {
namespace {

// A stage that settles for 100 s and one of 2 s after it, in which the block is pushed.
Model pushed(const TimeFunction& history) {
  Model model;
  model.blocks.resize(1);
  model.blocks[0].name = "b";
  model.stages.resize(2);
  model.stages[0].duration = 100;
  model.stages[1].duration = 2;
  PointLoad load;
  load.force = {1, 0};
  load.history = history;
  load.stages.first = 1;
  model.point_loads = {load};
  return model;
}

TEST(IdleLoads, ABlastBeforeItsStageBegins) {
  const std::vector<std::string> remarks = idle_loads(pushed(SineCycles{50, 1, 0}));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(
      remarks[0],
      "the load of block \"b\", sine of 50 Hz, cycles: 1, does nothing: it is zero but from 0 to 0.02 s on the scene's "
      "clock, and its stages run from 100 to 102 s");
}

TEST(IdleLoads, OneAfterTheRun) { EXPECT_EQ(idle_loads(pushed(SineCycles{50, 1, 102})).size(), 1U); }

TEST(IdleLoads, OneThatEndsWithItsStage) {
  Model model = pushed(SineCycles{50, 1, 100});
  model.point_loads[0].stages = {0, 0};
  EXPECT_EQ(idle_loads(model).size(), 1U);
}

TEST(IdleLoads, NothingOfWhatActs) {
  for (const TimeFunction& history :
       {TimeFunction{Constant{}}, TimeFunction{SineCycles{50, 1, 101.99}}, TimeFunction{SineCycles{50, INFINITY, 0}},
        TimeFunction{PiecewiseLinear{{0, 1}, {0, 1}}}, TimeFunction{PiecewiseLinear{{0, 1, 200}, {0, 0, 1}}},
        TimeFunction{ExponentialDecay{0.5, 0.1, 100}}})
    EXPECT_TRUE(idle_loads(pushed(history)).empty());
}

// Tables and recordings of zeros by lot, beside the same with one value that is not.
TEST(IdleLoads, HistoriesThatAreZeroAllTheTime) {
  std::mt19937 random(8);
  for (int i = 0; i < 30; ++i) {
    const auto points = std::uniform_int_distribution<std::size_t>(2, 40)(random);
    std::vector<double> times(points), values(points, 0.0);
    for (std::size_t k = 0; k < points; ++k) times[k] = 5.0 * static_cast<double>(k);
    const auto history = [&]() -> TimeFunction {
      if (i % 2 == 0) return PiecewiseLinear{times, values};
      return Recorded{std::make_shared<Recording>("r.csv", times, values), 100};
    };
    const std::vector<std::string> remarks = idle_loads(pushed(history()));
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("does nothing: it is zero all the time"), std::string::npos) << remarks[0];
    values.assign(points, 1e-6);
    EXPECT_TRUE(idle_loads(pushed(history())).empty());
  }
}

TEST(IdleLoads, OnceForAllBlocksOfAnEdge) {
  Model model = pushed(SineCycles{50, 1, 0});
  model.point_loads.resize(7, model.point_loads[0]);
  EXPECT_EQ(idle_loads(model).size(), 1U);
}

TEST(IdleLoads, MotionsOfSupportsAndHeldBlocks) {
  Model model = pushed(Constant{});
  PointSupport support;
  support.amplitude = {1e-3, 0};
  support.history = SineCycles{50, 1, 200};
  HeldBlock held;
  held.turn = 0.1;
  held.history = SineCycles{10, 1, 300};
  model.supports = {support};
  model.held_blocks = {held};
  const std::vector<std::string> remarks = idle_loads(model);
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].find("the motion of block \"b\", sine of 50 Hz, cycles: 1, does nothing"), 0U) << remarks[0];
  model.supports[0].amplitude.setZero();
  model.held_blocks[0].turn = 0;
  EXPECT_TRUE(idle_loads(model).empty()) << "they stand still whatever their history";
}

}  // namespace
}  // namespace dda
