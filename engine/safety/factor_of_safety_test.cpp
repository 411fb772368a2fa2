#include "engine/safety/factor_of_safety.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/safety/reduced_strength.h"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double width = 0.005;  // of the interval that the search ends with

Ring turned(Ring ring, double angle) {
  for (Vec2& vertex : ring) vertex = Eigen::Rotation2Dd(angle) * vertex;
  return ring;
}

// Boxes 1 m high and 2 m long, side by side on a held slope, from below upwards. Material k + 1 is that of box k.
Model boxes_on_slope(double slope, const std::vector<double>& frictions) {
  Model model;
  model.materials = {{"slope", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  const double length = 2.0 * static_cast<double>(frictions.size());
  model.blocks.emplace_back().shape.outer = turned({{-1, -1}, {length + 1, -1}, {length + 1, 0}, {-1, 0}}, slope);
  model.held_blocks.emplace_back().block = 0;
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    const double left = 2.0 * static_cast<double>(k);
    Block& box = model.blocks.emplace_back();
    box.shape.outer = turned({{left, 0}, {left + 2, 0}, {left + 2, 1}, {left, 1}}, slope);
    JointMaterial joint;
    joint.name = "base " + std::to_string(k);
    joint.friction_angle = frictions[k];
    model.joints.push_back(joint);
    model.joint_of_block_pair[{0, static_cast<int>(k) + 1}] = static_cast<int>(k) + 1;
  }
  model.gravity = {0, -9.81};
  return model;
}

TEST(FactorOfSafety, PlaneFailure) {
  for (const double slope : {20.0, 35.0}) {
    const SafetyReport report = factor_of_safety(boxes_on_slope(slope * degree, {40 * degree}), {});
    ASSERT_TRUE(report.is_bracketed());
    const double exact = std::tan(40 * degree) / std::tan(slope * degree);
    EXPECT_LE(report.stands, exact);
    EXPECT_GE(report.fails, exact);
    EXPECT_NEAR(report.factor() / exact, 1, width);
    EXPECT_FALSE(report.failure.reason.empty());
  }
}

// The lower box holds the upper one, until a stage of the model removes it.
TEST(FactorOfSafety, OfWhatStaysWhereBlocksAreRemoved) {
  Model model = boxes_on_slope(30 * degree, {40 * degree, 10 * degree});
  model.stages.resize(2);
  model.stages[1].removal.blocks = {1};
  const SafetyReport report = factor_of_safety(model, {});
  ASSERT_TRUE(report.is_bracketed());
  EXPECT_NEAR(report.factor() / (std::tan(10 * degree) / std::tan(30 * degree)), 1, width);
}

// c A + W cos(a) tan(f) over W sin(a), where the joint keeps its cohesion as it slides. A joint that loses it fails
// earlier: its lower end carries more, and goes first.
TEST(FactorOfSafety, PlaneFailureWithCohesion) {
  Model model = boxes_on_slope(40 * degree, {30 * degree});
  model.joints[1].cohesion = 15e3;
  model.joints[1].residual_cohesion = 15e3;
  const double weight = 2 * 2600 * 9.81;
  const double exact =
      (15e3 * 2 + weight * std::cos(40 * degree) * std::tan(30 * degree)) / (weight * std::sin(40 * degree));
  const SafetyReport ductile = factor_of_safety(model, {});
  ASSERT_TRUE(ductile.is_bracketed());
  EXPECT_NEAR(ductile.factor() / exact, 1, width);
  model.joints[1].residual_cohesion = 0;
  const SafetyReport brittle = factor_of_safety(model, {});
  ASSERT_TRUE(brittle.is_bracketed());
  EXPECT_LT(brittle.fails, 0.95 * exact);
  EXPECT_NEAR(factor_of_kept_strength(model, {}, brittle).factor() / exact, 1, width);
}

// Joints that have nothing to lose need no second search, and where they lose nothing it ends with its first run.
TEST(FactorOfSafety, KeptStrengthIsOfJointsThatLoseItAlone) {
  Model model = boxes_on_slope(20 * degree, {40 * degree});
  const auto kept_trials = [&model] {
    const SafetyReport report = factor_of_safety(model, {});
    const SafetyReport kept = factor_of_kept_strength(model, {}, report);
    EXPECT_EQ(kept.stands, 0);
    return kept.trials.size();
  };
  EXPECT_EQ(kept_trials(), 0U);
  model.joints[1].law = InterfaceLaw::projected;
  model.joints[1].cohesion = 15e3;
  EXPECT_EQ(kept_trials(), 1U);
}

// A wedge slides on a steep plane and pushes the block before it down a flat one, by a joint that ends in the knee of
// the two planes. Its line goes there as well; the lower block's corner touches the steep plane, but has none of the
// cohesion of the face that leans there.
Model wedge_behind_a_block() {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  JointMaterial plane, between;
  plane.friction_angle = 34 * degree;
  between.name = "between";
  between.friction_angle = 23 * degree;
  between.cohesion = between.residual_cohesion = 190e3;
  model.joints = {plane, between};
  const Vec2 toe(0, 0), knee(4.95, 1.92), up(2.58, 11.52), back(6.49, 11.52);
  const std::vector<Ring> rings{{{0, -8}, {17.5, -8}, knee + back + Vec2(6, 0), knee + back, knee, toe},
                                {toe, knee, knee + up, {4.66, 13.44}},
                                {knee + 0.043 * back, knee + back, knee + up, knee + 0.048 * up}};
  for (const Ring& ring : rings) model.blocks.emplace_back().shape.outer = ring;
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  model.joint_lines = {{knee, knee + up, 1}};
  return model;
}

TEST(FactorOfSafety, CohesionOfAFaceDoesNotHoldTheCornerAtItsEnd) {
  Model model = wedge_behind_a_block();
  const SafetyReport by_line = factor_of_safety(model, {});
  model.joint_lines.clear();
  model.joint_of_block_pair[{1, 2}] = 1;
  const SafetyReport by_pair = factor_of_safety(model, {});
  ASSERT_TRUE(by_line.is_bracketed() && by_pair.is_bracketed());
  EXPECT_NEAR(by_line.factor() / by_pair.factor(), 1, width);
}

// The upper box leans on the lower one, which has friction to spare: both go when their frictions together do not hold
// their weights.
TEST(FactorOfSafety, BoxesThatLeanOnEachOther) {
  const double slope = 25 * degree;
  const SafetyReport report = factor_of_safety(boxes_on_slope(slope, {45 * degree, 20 * degree}), {});
  const double exact = (std::tan(45 * degree) + std::tan(20 * degree)) / 2 / std::tan(slope);
  ASSERT_TRUE(report.is_bracketed());
  EXPECT_NEAR(report.factor() / exact, 1, width);
  for (const std::size_t box : {std::size_t{1}, std::size_t{2}}) EXPECT_GT(report.failure.movement[box].norm(), 1e-3);
}

std::vector<double> factors_of(const SafetyReport& report) {
  std::vector<double> factors;
  for (const SafetyTrial& trial : report.trials) factors.push_back(trial.factor);
  return factors;
}

// A box that stands at 8 times less, one that stands at once and one that needs 5 times more, and one that never
// slides.
TEST(FactorOfSafety, ManyJobsFindWhatOneFinds) {
  for (const double exact : {9.7, 1.2, 0.2}) {
    const Model model = boxes_on_slope(20 * degree, {std::atan(exact * std::tan(20 * degree))});
    const SafetyReport one = factor_of_safety(model, {.jobs = 1});
    ASSERT_TRUE(one.is_bracketed());
    EXPECT_EQ(factors_of(one), factors_of(factor_of_safety(model, {.jobs = 2})));
    for (const int jobs : {3, 4, 7}) {
      const SafetyReport many = factor_of_safety(model, {.jobs = jobs});
      ASSERT_TRUE(many.is_bracketed());
      EXPECT_LE(many.fails / many.stands, 1 + width);
      EXPECT_NEAR(many.factor() / exact, 1, width);
      EXPECT_NEAR(many.factor() / one.factor(), 1, width);
      EXPECT_EQ(factors_of(many), factors_of(factor_of_safety(model, {.jobs = jobs})));
    }
  }
  EXPECT_EQ(factor_of_safety(boxes_on_slope(0, {20 * degree}), {.most = 8, .jobs = 5}).trials.size(), 4U);
}

// The interval narrows N + 1 times in a round of N jobs: 2 to 1 needs 4 rounds of 3 jobs to be narrower than 0.5 %.
TEST(FactorOfSafety, ARoundOfNJobsPartsTheIntervalInNPlusOne) {
  const Model model = boxes_on_slope(20 * degree, {std::atan(1.9 * std::tan(20 * degree))});
  const SafetyReport report = factor_of_safety(model, {.jobs = 3});
  ASSERT_TRUE(report.is_bracketed());
  EXPECT_NEAR(std::log(report.fails / report.stands), std::log(2) / 256, 1e-12);
}

TEST(FactorOfSafety, LevelGroundHasNone) {
  const SafetyReport report = factor_of_safety(boxes_on_slope(0, {20 * degree}), {.most = 8});
  EXPECT_EQ(report.stands, 8);
  EXPECT_EQ(report.fails, 0);
}

TEST(FactorOfSafety, WhatNothingHoldsStandsAtNoStrength) {
  Model model = boxes_on_slope(0, {20 * degree});
  for (Vec2& vertex : model.blocks[1].shape.outer) vertex.x() += 100;
  const SafetyReport report = factor_of_safety(model, {});
  EXPECT_EQ(report.stands, 0);
  EXPECT_EQ(report.trials.size(), 1U);
  EXPECT_FALSE(report.failure.is_loaded);
  EXPECT_NE(report.failure.reason.find("nothing holds"), std::string::npos);
}

// Absorbing edges carry no steady load, so whatever the strength there is no state from which to ask for a factor.
TEST(FactorOfSafety, WhatIsNotInBalanceUnderItsLoadsStandsAtNoStrength) {
  Model model = boxes_on_slope(0, {20 * degree});
  model.held_blocks.clear();
  model.viscous_edges.push_back({0, {-1, -1}, {3, -1}, 1e7, 5e6});
  const SafetyReport report = factor_of_safety(model, {});
  EXPECT_EQ(report.stands, 0);
  EXPECT_EQ(report.trials.size(), 1U);
  EXPECT_FALSE(report.failure.is_loaded);
  EXPECT_NE(report.failure.reason.find("out of balance"), std::string::npos) << report.failure.reason;
}

TEST(FactorOfSafety, ReducesEveryStrengthButNotThatOfIntactRock) {
  Model model = boxes_on_slope(0, {45 * degree});
  JointMaterial& joint = model.joints[1];
  joint.residual_friction_angle = 45 * degree;
  joint.cohesion = 4;
  joint.residual_cohesion = 2;
  joint.tensile_strength = 6;
  joint.dilation_angle = 45 * degree;
  model.joints[0].bonded = true;
  model.joints[0].cohesion = 8;
  const Model half = with_strength_over(2, model);
  const double angle = std::atan(0.5);
  EXPECT_DOUBLE_EQ(half.joints[1].friction_angle, angle);
  EXPECT_DOUBLE_EQ(*half.joints[1].residual_friction_angle, angle);
  EXPECT_DOUBLE_EQ(half.joints[1].dilation_angle, angle);
  EXPECT_EQ(half.joints[1].cohesion, 2);
  EXPECT_EQ(half.joints[1].residual_cohesion, 1);
  EXPECT_EQ(half.joints[1].tensile_strength, 3);
  EXPECT_EQ(half.joints[0].cohesion, 8);
}

}  // namespace
}  // namespace dda
