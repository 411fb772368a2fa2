#include "engine/advice/sudden_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/advice/advice.h"
#include "engine/advice/advise.h"
#include "engine/advice/lattice_test_support.h"
#include "engine/advice/load_history.h"

namespace dda {
namespace {

constexpr double dt = 1e-4;

// A bar of 30 blocks of 2 m; the load pushes its left end.
Model pushed(const TimeFunction& history) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 2, 30);
  model.materials[0].young = 50e9;  // 4,385 m/s
  model.stages[0].dt = dt;
  model.stages[0].duration = 0.012;
  model.edge_loads.push_back({0, {0, 0.8}, {0, 0}, {1, 0}, history});
  finish_model(model);
  return model;
}

Advice advice_on(const Model& model) { return advise(Simulation(model), {}); }

TEST(SuddenLoads, FindsWhatJumps) {
  const std::vector<TimeFunction> sudden = {Constant{},
                                            PiecewiseLinear{{0, 1}, {1, 1}},
                                            PiecewiseLinear{{0, 1e-3, 1.0001e-3, 1}, {0, 0, 1, 1}},
                                            PiecewiseLinear{{0, 1e-3, 1.02e-3, 1}, {0, 0, 1, 1}},
                                            SineCycles{300, 1.25, 0},
                                            ExponentialDecay{1e-3, 2e-3, 0}};
  for (const TimeFunction& history : sudden) {
    const Model model = pushed(history);
    const std::vector<LoadFinding> found = sudden_loads(model);
    ASSERT_EQ(found.size(), 1U) << words_for(history);
    EXPECT_EQ(found[0].history, &model.edge_loads[0].history);
    EXPECT_NE(found[0].sentence.find("jumps"), std::string::npos);
  }
}

// One record on the edges of many blocks is looked at once, and two tables that jump at one time are two findings.
TEST(SuddenLoads, AreAskedOncePerHistory) {
  Model model = pushed(PiecewiseLinear{{0, 1e-3, 1.0001e-3, 1}, {0, 0, 1, 1}});
  const EdgeLoad same = model.edge_loads[0];
  for (int i = 0; i < 3; ++i) model.edge_loads.push_back(same);
  model.edge_loads.push_back(same);
  model.edge_loads.back().history = PiecewiseLinear{{0, 1e-3, 1.0001e-3, 1}, {0, 0, 1, 0}};
  const std::vector<LoadFinding> found = sudden_loads(model);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].sentence.find("and 3 more"), std::string::npos) << found[0].sentence;
  EXPECT_EQ(found[1].sentence.find("more"), std::string::npos) << found[1].sentence;
}

// Pulses of as many points that are over between the few times at which all histories are looked at.
TEST(SuddenLoads, ShortTablesAreToldApart) {
  const PiecewiseLinear smooth{{1.2e-3, 1.9e-3, 2.6e-3}, {0, 1, 0}}, sudden{{1.2e-3, 1.2001e-3, 2.6e-3}, {0, 1, 0}};
  Model model = pushed(smooth);
  model.edge_loads.push_back(model.edge_loads[0]);
  model.edge_loads.back().history = sudden;
  EXPECT_EQ(sudden_loads(model).size(), 1U);
  std::swap(model.edge_loads[0], model.edge_loads[1]);
  const std::vector<LoadFinding> found = sudden_loads(model);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].sentence.find("more"), std::string::npos) << found[0].sentence;
}

TEST(SuddenLoads, SaysNothingOfWhatRises) {
  for (const TimeFunction& history : std::vector<TimeFunction>{
           SineCycles{300, 1, 0}, SineCycles{300, INFINITY, 1e-3}, ExponentialDecay{1e-3, 0, 5e-4},
           PiecewiseLinear{{0, 1e-3, 2e-3}, {0, 1, 0}}, PiecewiseLinear{{0.1, 1}, {0, 1}}})
    EXPECT_TRUE(sudden_loads(pushed(history)).empty()) << words_for(history);
}

// What a static stage, or the stress the rock begins with, has in balance comes with no wave.
TEST(SuddenLoads, WhatIsInBalanceIsNoJump) {
  Model settled = pushed(Constant{});
  settled.stages.insert(settled.stages.begin(), settled.stages[0]);
  settled.stages[0].integrator = static_integrator();
  EXPECT_TRUE(sudden_loads(settled).empty());
  Model stressed = pushed(Constant{});
  stressed.blocks[0].initial_stress = {-1, 0, 0};
  EXPECT_TRUE(sudden_loads(stressed).empty());
  stressed.blocks[0].initial_stress = {1, 0, 0};
  EXPECT_EQ(sudden_loads(stressed).size(), 1U);
}

TEST(SuddenLoads, MotionsJumpByTheirVelocity) {
  const auto moved = [](MotionKind kind, const TimeFunction& history) {
    Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 2, 30);
    HeldBlock held;
    held.amplitude = {1e-3, 0};
    held.kind = kind;
    held.history = history;
    model.held_blocks.push_back(held);
    return sudden_loads(model).size();
  };
  EXPECT_EQ(moved(MotionKind::velocity, Constant{}), 1U);
  EXPECT_EQ(moved(MotionKind::acceleration, Constant{}), 0U);
  EXPECT_EQ(moved(MotionKind::displacement, PiecewiseLinear{{0, 1}, {0, 1}}), 1U);
  EXPECT_EQ(moved(MotionKind::velocity, PiecewiseLinear{{0, 1}, {0, 1}}), 0U);
}

TEST(SuddenLoads, StandInPlaceOfFigures) {
  const Advice advice = advice_on(pushed(PiecewiseLinear{{0, 1}, {1, 1}}));
  ASSERT_EQ(advice.sudden.size(), 1U);
  const WaveAdvice& wave = advice.stages[0].waves.at(0);
  EXPECT_FALSE(wave.history.has_value());
  EXPECT_FALSE(wave.limits.has_value());
  EXPECT_NE(to_text(advice).find("it jumps, which no mesh and dt carry"), std::string::npos);
  EXPECT_NE(to_text(advice_on(pushed(Constant{}))).find("constant, jumps at 0 s"), std::string::npos);
}

// Another load beside the one that is advised on: it is named, and figures stay where its wave comes too late to be
// seen.
TEST(SuddenLoads, StandBesideFiguresOfOtherLoads) {
  const auto advice_with_jump_at = [](double x, double distance) {
    Model model = pushed(PiecewiseLinear{{0, 1e-3, 2e-3}, {0, 1, 0}});
    model.edge_loads.push_back({static_cast<int>(x / 2) - 1, {x, 0}, {x, 0.8}, {5, 0}, Constant{}});
    finish_model(model);
    AdviceQuestion question;
    question.distance = distance;
    const Advice advice = advise(Simulation(model), question);
    EXPECT_EQ(advice.sudden.size(), 1U);
    EXPECT_NE(advice.sudden.at(0).find(model.blocks[static_cast<std::size_t>(x / 2) - 1].name), std::string::npos);
    return advice;
  };
  const WaveAdvice far_away = advice_with_jump_at(60, 8).stages[0].waves.at(0);
  EXPECT_TRUE(far_away.history.has_value()) << far_away.not_foretold;
  const WaveAdvice near_by = advice_with_jump_at(60, 40).stages[0].waves.at(0);
  EXPECT_FALSE(near_by.history.has_value());
  EXPECT_NE(near_by.not_foretold.find("something else jumps"), std::string::npos) << near_by.not_foretold;
}

// A place that swings as a sine begins with its largest velocity and ends with it: of two periods of 50 steps each the
// steps beside that hold 2 %, by which readings differ from each other; of 24 that go on to the end of the run 0.08 %.
TEST(SuddenLoads, VelocitiesThatJumpHaveFiguresWhereJumpsWeighLittle) {
  const auto history_of = [](double cycles, double duration) {
    Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 2, 30);
    model.materials[0].young = 50e9;
    model.stages[0].dt = dt;
    model.stages[0].duration = duration;
    HeldBlock held;
    held.amplitude = {1e-3, 0};
    held.history = SineCycles{200, cycles, 0};
    model.held_blocks.push_back(held);
    finish_model(model);
    AdviceQuestion question;
    question.limits = false;
    return advise(Simulation(model), question).stages[0].waves.at(0);
  };
  const WaveAdvice brief = history_of(2, 0.012);
  EXPECT_FALSE(brief.history.has_value());
  EXPECT_NE(brief.not_foretold.find("its velocity jumps, and 2 % of it"), std::string::npos) << brief.not_foretold;
  EXPECT_TRUE(history_of(INFINITY, 0.12).history.has_value());
}

// What steps pass over, and pulses with fewer than four steps in a period of theirs, or shorter than four blocks.
TEST(SuddenLoads, AndShortOnesHaveNoFigures) {
  const auto has_figures = [](double rise) {
    const Advice advice = advice_on(pushed(PiecewiseLinear{{0, rise, 2 * rise}, {0, 1, 0}}));
    EXPECT_TRUE(advice.sudden.empty());
    return advice.stages[0].waves.at(0).history.has_value();
  };
  EXPECT_TRUE(has_figures(2e-3));
  EXPECT_FALSE(has_figures(5e-5));  // seen by one step or by none
  EXPECT_FALSE(has_figures(3e-4));  // 2.6 m at 4,385 m/s, in blocks of 2 m
}

}  // namespace
}  // namespace dda
