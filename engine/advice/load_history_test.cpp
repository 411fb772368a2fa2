#include "engine/advice/load_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/contact/contact_models.h"

namespace dda {
namespace {

Model two_blocks() {
  Model model;
  model.materials = {rock()};
  model.joints = {JointMaterial{}};
  for (int i = 0; i < 2; ++i) model.blocks.emplace_back().shape.outer = box_ring(i, 0, i + 1, 1);
  model.blocks.front().name = "first";
  Stage stage;
  stage.dt = 1e-4;
  stage.duration = 0.1;
  model.stages = {stage};
  finish_model(model);
  return model;
}

TEST(LoadHistory, HighestSineOfLoadsAndSupports) {
  Model model = two_blocks();
  EXPECT_FALSE(highest_sine_frequency(model).has_value());
  model.point_loads.push_back({0, {0, 0}, {1, 0}, SineCycles{30, 1, 0}});
  EXPECT_EQ(highest_sine_frequency(model), 30);
  model.supports.push_back({0, {0, 0}, true, true, 1e9, {1, 0}, SineCycles{70, 1, 0}});
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, ExponentialDecay{1e-3, 0}});
  EXPECT_EQ(highest_sine_frequency(model), 70);
}

TEST(LoadHistory, ConstantLoadsAreNoWaves) {
  Model model = two_blocks();
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, Constant{}});
  EXPECT_FALSE(scene_load(model).has_value());
  model.point_loads.push_back({0, {0, 0.5}, {1, 0}, SineCycles{50, 2, 0.01}});
  const auto load = scene_load(model);
  ASSERT_TRUE(load.has_value());
  EXPECT_EQ(load->place, Vec2(0, 0.5));
  EXPECT_DOUBLE_EQ(load->history.period, 0.02);
  EXPECT_NEAR(load->history.duration, 0.04, 2e-4);  // two samples; from where it begins
  EXPECT_EQ(load->history.value(-1), 0);
  EXPECT_NEAR(load->history.value(0.005), 1, 1e-12);
}

// As after a static stage of 10 s: what a load does is counted from where it begins.
TEST(LoadHistory, SilenceBeforeALoadDoesNotCount) {
  Stage settle;
  settle.dt = settle.duration = 10;
  for (const auto& [late, at_once] :
       {std::pair<TimeFunction, TimeFunction>(SineCycles{50, 1, 10}, SineCycles{50, 1, 0}),
        {PiecewiseLinear{{0, 10, 10.01, 10.02}, {0, 0, 1, 0}}, PiecewiseLinear{{0, 0.01, 0.02}, {0, 1, 0}}}}) {
    Model model = two_blocks();
    model.point_loads.push_back({0, {0, 0.5}, {1, 0}, at_once});
    const auto expected = scene_load(model);
    model.point_loads[0].history = late;
    model.stages.insert(model.stages.begin(), settle);
    const auto load = scene_load(model);
    ASSERT_TRUE(load && expected);
    EXPECT_NEAR(load->history.period, expected->history.period, 1e-9);
    EXPECT_NEAR(load->history.duration, expected->history.duration, 2e-4);
    for (const double t : {0.004, 0.011, 0.018})
      EXPECT_NEAR(load->history.value(t), expected->history.value(t), 1e-9) << t;
  }
}

// Six cycles under an envelope: the spectrum is largest at their frequency; one transform bin is 5 Hz.
TEST(LoadHistory, MainFrequencyOfATable) {
  Model model = two_blocks();
  PiecewiseLinear table;
  for (int i = 0; i <= 600; ++i) {
    const double t = i * 1e-4;
    table.times.push_back(t);
    table.values.push_back(std::pow(std::sin(std::numbers::pi * t / 0.06), 2) *
                           std::sin(2 * std::numbers::pi * 100 * t));
  }
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, table});
  EXPECT_NEAR(1 / scene_load(model)->history.period, 100, 5);
}

// A run samples a load at the ends of its steps, whenever that begins.
TEST(LoadHistory, BeginsAtTheEndOfAStep) {
  Model model = two_blocks();  // in steps of 1e-4 s
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, SineCycles{50, 2, 0.01037}});
  const auto load = scene_load(model);
  EXPECT_NEAR(load->history.start, 0.0103, 1e-12);
  EXPECT_NEAR(load->history.duration, 0.04 + 7e-5, 1e-12);
  for (int i = 0; i < 400; ++i)
    EXPECT_NEAR(load->history.value(i * 1e-4), evaluate(model.edge_loads[0].history, (i + 103) * 1e-4), 1e-12) << i;
}

// A push that never changes its sign has no frequency of its own: half a period is its duration at most.
TEST(LoadHistory, APulseOfOneSign) {
  Model model = two_blocks();
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, PiecewiseLinear{{0, 0.01, 0.02}, {0, 1, 0}}});
  const auto load = scene_load(model);
  EXPECT_NEAR(load->history.duration, 0.02, 2e-4);
  EXPECT_NEAR(load->history.period, 0.04, 1e-3);
}

// It was twice the run, and waves were looked for as far from where they are due.
TEST(LoadHistory, ARiseThatStaysIsAQuarterOfAPeriod) {
  Model model = two_blocks();
  model.edge_loads.push_back({0, {0, 0}, {0, 1}, {1, 0}, PiecewiseLinear{{0, 0.01, 1}, {0, 1, 1}}});
  EXPECT_NEAR(scene_load(model)->history.period, 0.04, 1e-3);
}

}  // namespace
}  // namespace dda
