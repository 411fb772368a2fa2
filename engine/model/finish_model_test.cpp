#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include "engine/core/error.h"
#include "engine/geometry/rotation.h"
#include "engine/model/model.h"

namespace dda {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Block rectangle(const std::string& name, double left, double width, double height) {
  Block block;
  block.name = name;
  block.shape.outer = {{left, 0}, {left + width, 0}, {left + width, height}, {left, height}};
  return block;
}

// Two touching blocks of 2 m x 1 m with one of everything.
Model complete_model() {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::strain}};
  model.joints = {{}, {}};
  model.blocks = {rectangle("a", 0, 2, 1), rectangle("b", 2, 2, 1)};
  model.joint_of_block_pair[{0, 1}] = 1;
  model.point_loads = {{0, {0, 0.5}, {1e3, 0}, SineCycles{100, 1, 0}}};
  model.edge_loads = {{1, {4, 0}, {4, 1}, {0, -1e3}, PiecewiseLinear{{0, 1}, {0, 1}}}};
  model.supports = {{0, {0, 0}, true, true, 1e12, {0, 0}, Constant{}}};
  model.viscous_edges = {{1, {2, 1}, {4, 1}, 1e7, 5e6}};
  model.measurements = {{"s", Quantity::stress_xx, 0, -1, {1, 0.5}}, {"t", Quantity::traction_normal, 0, 1, {2, 0.5}}};
  Stage stage;
  stage.dt = 1e-5;
  stage.duration = 1e-2;
  model.stages = {stage};
  return model;
}

TEST(FinishModel, FillsMomentsAndTolerance) {
  Model model = complete_model();
  finish_model(model);
  EXPECT_DOUBLE_EQ(model.blocks[1].moments.area, 2);
  EXPECT_DOUBLE_EQ(model.blocks[1].moments.centroid.x(), 3);
  EXPECT_DOUBLE_EQ(model.blocks[1].moments.xx, 8.0 / 12);
  EXPECT_DOUBLE_EQ(model.mass_of(1), 5000);
  EXPECT_DOUBLE_EQ(model.length_tolerance, 1e-9 * std::sqrt(17.0));
}

// Static steps tell by the tolerance which ends touch: its size must not depend on the axes of the drawing.
TEST(FinishModel, ToleranceIsTheSameWhicheverWayTheSceneIsTurned) {
  for (const double angle : {0.0, 0.35, 0.7, 1.2}) {
    Model model;
    model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::strain}};
    model.blocks = {rectangle("a", 0, 2, 1), rectangle("b", 2, 2, 1)};
    for (Block& block : model.blocks)
      for (Vec2& corner : block.shape.outer) corner = rotation(angle) * corner;
    finish_model(model);
    EXPECT_NEAR(model.length_tolerance, 1e-9 * std::sqrt(17.0), 1e-22) << angle;
  }
}

// Springs that the engine chooses go by the pressure that it expects, of which the initial stress is a part.
TEST(FinishModel, ExpectsTheSamePressureWhicheverWayTheSceneIsTurned) {
  for (const double angle : {0.0, 0.35, 0.7, 1.2, 2.8}) {
    Model model = complete_model();
    model.edge_loads.clear();
    model.point_loads.clear();
    for (Block& block : model.blocks) block.initial_stress = rotate_stress({-2e6, 1e6, 0.5e6}, -angle);
    finish_model(model);
    EXPECT_NEAR(model.expected.pressure, 0.5e6 + std::hypot(1.5e6, 0.5e6), 1e-3) << angle;
  }
}

TEST(FinishModel, TurnsOutlinesCounterClockwise) {
  Model model = complete_model();
  model.blocks[0].shape.outer = {{0, 0}, {0, 1}, {2, 1}, {2, 0}};
  finish_model(model);
  EXPECT_GT(signed_area(model.blocks[0].shape.outer), 0);
}

TEST(FinishModel, AddsADefaultJoint) {
  Model model = complete_model();
  model.joints.clear();
  model.joint_of_block_pair.clear();
  finish_model(model);
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].name, "default");
}

TEST(FinishModel, JointOfAPairIsFoundInEitherOrder) {
  const Model model = complete_model();
  EXPECT_EQ(&model.joint_between(1, 0), &model.joints[1]);
  EXPECT_EQ(&model.joint_between(0, 1), &model.joints[1]);
  EXPECT_EQ(&model.joint_between(1, 2), &model.joints[0]);
}

struct Spoiled {
  std::string what;
  std::function<void(Model&)> spoil;
  std::string field;  // parts the sentence must have
  std::string value;
};

void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.what; }

class BadModel : public testing::TestWithParam<Spoiled> {};

TEST_P(BadModel, IsRefusedInASentenceWithFieldAndValue) {
  Model model = complete_model();
  GetParam().spoil(model);
  try {
    finish_model(model);
    FAIL() << "accepted: " << GetParam().what;
  } catch (const InputError& error) {
    EXPECT_NE(error.field().find(GetParam().field), std::string::npos) << error.what();
    EXPECT_NE(error.value().find(GetParam().value), std::string::npos) << error.what();
  }
}

const std::vector<Spoiled> spoiled = {
    {"no materials", [](Model& m) { m.materials.clear(); }, "materials", "empty"},
    {"no blocks", [](Model& m) { m.blocks.clear(); }, "blocks", "empty"},
    {"density", [](Model& m) { m.materials[0].density = -1; }, "materials \"rock\" density", "-1"},
    {"nan density", [](Model& m) { m.materials[0].density = nan_value; }, "density", "nan"},
    {"young", [](Model& m) { m.materials[0].young = 0; }, "Young", "0"},
    {"light", [](Model& m) { m.materials[0].young = 1e308; }, "Young", "1e+308"},
    {"poisson in plane strain", [](Model& m) { m.materials[0].poisson = 0.5; }, "Poisson", "0.5"},
    {"poisson below -1", [](Model& m) { m.materials[0].poisson = -1; }, "Poisson", "-1"},
    {"friction", [](Model& m) { m.joints[1].friction_angle = 35; }, "joints[1] friction angle", "35"},
    {"cohesion", [](Model& m) { m.joints[0].cohesion = -2; }, "cohesion", "-2"},
    {"tension", [](Model& m) { m.joints[0].tensile_strength = nan_value; }, "tensile", "nan"},
    {"penalty", [](Model& m) { m.joints[0].penalty = 1; }, "penalty", "1"},
    {"joint index",
     [](Model& m) {
       m.joint_of_block_pair[{0, 1}] = 7;
     },
     "joint", "7"},
    {"pair order",
     [](Model& m) {
       m.joint_of_block_pair[{1, 0}] = 0;
     },
     "pair", "(1, 0)"},
    {"relaxation above 1",
     [](Model& m) {
       m.stages.push_back(m.stages[0]);
       m.stages[1].removal = {{1}, PiecewiseLinear{{0, 1}, {1, 2}}};
     },
     "relaxation", "2"},
    {"material index", [](Model& m) { m.blocks[1].material = 1; }, "blocks \"b\" material", "1"},
    {"zero area", [](Model& m) { m.blocks[0].shape.outer[2].y() = m.blocks[0].shape.outer[3].y() = 0; }, "shape",
     "degenerate"},
    {"crossing", [](Model& m) { std::swap(m.blocks[0].shape.outer[0], m.blocks[0].shape.outer[1]); }, "shape",
     "self-intersecting"},
    {"nan vertex", [](Model& m) { m.blocks[0].shape.outer[0].x() = nan_value; }, "shape", "nan"},
    {"same names", [](Model& m) { m.blocks[1].name = "a"; }, "blocks \"a\" name", "a"},
    {"overlap", [](Model& m) { m.blocks[1].shape.outer[3].x() = 1.9; }, "blocks \"b\"", "overlapping \"a\""},
    {"stress", [](Model& m) { m.blocks[0].initial_stress.z() = nan_value; }, "initial stress", "nan"},
    {"gravity", [](Model& m) { m.gravity.y() = nan_value; }, "gravity", "not finite"},
    {"load block", [](Model& m) { m.point_loads[0].block = 2; }, "point_loads[0] block", "2"},
    {"load point", [](Model& m) { m.point_loads[0].point.x() = -1; }, "point_loads[0] point", "(-1, 0.5)"},
    {"frequency", [](Model& m) { m.point_loads[0].history = SineCycles{}; }, "frequency", "0"},
    {"decay", [](Model& m) { m.point_loads[0].history = ExponentialDecay{}; }, "decay time", "0"},
    {"rise",
     [](Model& m) {
       m.point_loads[0].history = ExponentialDecay{1, 0, -2};
     },
     "rise", "-2"},
    {"times",
     [](Model& m) {
       m.edge_loads[0].history = PiecewiseLinear{{1, 1}, {0, 1}};
     },
     "edge_loads[0] history", "1"},
    {"no table", [](Model& m) { m.edge_loads[0].history = PiecewiseLinear{}; }, "history", "0 times"},
    {"edge inside",
     [](Model& m) {
       m.edge_loads[0].to = {3, 0.5};
     },
     "edge_loads[0] edge", "(3, 0.5)"},
    {"edge without length",
     [](Model& m) {
       m.edge_loads[0].to = {4, 0};
     },
     "edge length", "0"},
    {"stiffness", [](Model& m) { m.supports[0].stiffness = 0; }, "supports[0] stiffness", "0"},
    {"holds nothing", [](Model& m) { m.supports[0].holds_x = m.supports[0].holds_y = false; }, "hold", "neither"},
    {"impedance", [](Model& m) { m.viscous_edges[0].shear_impedance = -1; }, "shear impedance", "-1"},
    {"first stage", [](Model& m) { m.viscous_edges[0].first_stage = 1; }, "first stage", "1"},
    {"last stage", [](Model& m) { m.supports[0].last_stage = 7; }, "last stage", "7"},
    {"release without an end", [](Model& m) { m.supports[0].takes_force_along = true; }, "supports[0] taking its force",
     "asked for"},
    {"measured block", [](Model& m) { m.measurements[0].block = -1; }, "measurements \"s\" block", "-1"},
    {"measured point", [](Model& m) { m.measurements[0].point.y() = 2; }, "measurements \"s\" point", "(1, 2)"},
    {"one block of a traction", [](Model& m) { m.measurements[1].other_block = -1; }, "other block", "-1"},
    {"same names of measurements", [](Model& m) { m.measurements[1].name = "s"; }, "measurements \"s\" name", "used"},
    {"dt", [](Model& m) { m.stages[0].dt = 0; }, "stages \"run\" dt", "0"},
    {"duration", [](Model& m) { m.stages[0].duration = -1; }, "duration", "-1"},
    {"steps without end", [](Model& m) { m.stages[0].dt = 1e-300; }, "duration in steps", "e+"},
    {"rho_inf", [](Model& m) { m.stages[0].integrator = generalized_alpha_integrator(-0.1); }, "alpha", "-"},
    {"velocity factor", [](Model& m) { m.stages[0].velocity_factor = 1.01; }, "velocity factor", "1.01"},
    {"iterations", [](Model& m) { m.stages[0].limits.open_close_iterations = 0; }, "open-close", "0"},
};

INSTANTIATE_TEST_SUITE_P(FinishModel, BadModel, testing::ValuesIn(spoiled));

// Blocks rounded into each other by less than the tolerance still only touch.
// Blocks of 2 m x 1 m have principal moments in the ratio of 4 to 1: (3/5)^2.
TEST(FinishModel, StrainInertiaLeavesInertiaInAllMotion) {
  Model model = complete_model();
  model.stages[0].strain_inertia = 0.3601;
  EXPECT_NO_THROW(finish_model(model));
  model.stages[0].strain_inertia = 0.3599;
  try {
    finish_model(model);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("strain inertia is 0.3599, expected above 0.36: with less, block \"a\""),
              std::string::npos)
        << error.what();
  }
}

TEST(FinishModel, TouchingWithinRoundOffIsNoOverlap) {
  Model model = complete_model();
  model.blocks[1].shape.outer[0].x() -= 1e-12;
  EXPECT_NO_THROW(finish_model(model));
}

}  // namespace
}  // namespace dda
