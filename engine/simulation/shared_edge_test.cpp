// Tractions on joints along which blocks slide, as measurements read them.
#include "engine/simulation/shared_edge.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/error.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double pressure = 2e6;  // Pa
constexpr double friction = 0.5;

JointMaterial dry_joint() {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = std::atan(friction);
  return joint;
}

// A box, 1 m wide, on a base that reaches from 0 to `right`, pressed on it and pulled to the right by `pull`. All
// turned by `angle`. Measures both tractions in the middle of their joint.
Model pulled_box(double right, double pull, int steps, double angle = 0) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_joint()};
  model.blocks = {rectangle("base", 0, -1, right, 1), rectangle("box", 0, 0, 1, 0.5)};
  place(model, angle);
  const auto at = [&](double x, double y) { return Vec2(rotation(angle) * Vec2(x, y)); };
  for (const Vec2& corner : {at(0, -1), at(right, -1), at(0, 0), at(right, 0)})
    model.supports.push_back({0, corner, true, true, 1e13, Vec2::Zero(), Constant{}});
  for (const Vec2& corner : {at(0, 0), at(1, 0)})
    model.supports.push_back({1, corner, true, true, 1e7, at(pull, 0), PiecewiseLinear{{0, 1.0 * steps}, {0, 1}}});
  model.edge_loads = {{1, at(1, 0.5), at(0, 0.5), at(0, -pressure), Constant{}}};
  model.stages = {stage_of(static_integrator(), 1, steps, Kinematics::finite)};
  model.measurements = {{"normal", Quantity::traction_normal, 0, 1, at(0.5, 0)},
                        {"shear", Quantity::traction_shear, 0, 1, at(0.5, 0)},
                        {"normal of the box", Quantity::traction_normal, 1, 0, at(0.5, 0)},
                        {"shear of the box", Quantity::traction_shear, 1, 0, at(0.5, 0)}};
  return model;
}

std::array<double, 4> sample(const Simulation& simulation, const Probes& probes) {
  std::array<double, 4> values{};
  probes.sample(simulation, values);
  return values;
}

// The supports of the box are soft: what they take of the load is 1e7 N/m times a few um.
TEST(SharedEdge, TractionsOfASlidingJointWhicheverWayItLies) {
  for (const double angle : {0.0, 0.7, -2.5}) {
    Simulation simulation = simulation_of(pulled_box(3, 1, 200, angle));
    const Probes probes(simulation);
    EXPECT_NEAR(sample(simulation, probes)[0], 0, 1e-9 * pressure);
    run(simulation, 200);
    // Slid by 1 m less what pulls the supports: 1 MN over 2e7 N/m.
    const Vec2 moved = simulation.state().displacement[1].head<2>();
    EXPECT_NEAR(moved.norm(), 0.95, 0.01);
    const auto [normal, shear, of_box, shear_of_box] = sample(simulation, probes);
    EXPECT_NEAR(normal, -pressure, 2e-3 * pressure) << angle;
    // The tangent points to the left, along which the base holds the box back: positive on what lies on the normal's
    // side.
    EXPECT_NEAR(shear, -friction * pressure, 2e-3 * pressure) << angle;
    // Lengths of two edges that are strained by 1e-3 and turned by as much.
    EXPECT_NEAR(of_box, normal, 2e-3 * pressure);
    EXPECT_NEAR(shear_of_box, shear, 2e-3 * pressure);
  }
}

// The box leaves its base by 0.3 m: the same force on less.
TEST(SharedEdge, OnlyTheLengthInCommonCounts) {
  Simulation simulation = simulation_of(pulled_box(1, 0.35, 100));
  const Probes probes(simulation);
  run(simulation, 100);
  const double slid = simulation.state().displacement[1](0);
  EXPECT_NEAR(slid, 0.3, 0.01);
  const auto [normal, shear, of_box, shear_of_box] = sample(simulation, probes);
  // What the overhang's moment takes from the supports, 2e7 N/m times a sag of a millimetre, is a hundredth.
  EXPECT_NEAR(normal, -pressure / (1 - slid), 0.02 * pressure);
  EXPECT_NEAR(shear, friction * normal, 0.02 * pressure);
}

// A joint with strength that breaks elsewhere first: the list of interfaces changes under the measurement.
TEST(SharedEdge, MeasuresTheSameJointWhenOthersBreak) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_joint(), dry_joint()};
  model.joints[1].tensile_strength = model.joints[1].cohesion = 1e9;
  model.joints[0].tensile_strength = model.joints[0].cohesion = 1e3;
  model.blocks = {rectangle("weak", 0, -1, 1, 1), rectangle("base", 0, 0, 1, 1), rectangle("top", 0, 1, 1, 1)};
  model.joint_of_block_pair = {{{1, 2}, 1}};
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0)})
    model.supports.push_back({1, corner, true, true, 1e13, Vec2::Zero(), Constant{}});
  model.edge_loads = {{2, {1, 2}, {0, 2}, {0, -pressure}, Constant{}}, {0, {0, -1}, {1, -1}, {0, -1e4}, Constant{}}};
  model.measurements = {{"normal", Quantity::traction_normal, 1, 2, {0.5, 1}}};
  model.stages = {stage_of(thesis_integrator(), 1e-3, 400, Kinematics::finite)};
  model.stages[0].damping_rate = 100;
  Simulation simulation = simulation_of(std::move(model));
  const Probes probes(simulation);
  run(simulation, 400);
  EXPECT_LT(simulation.state().displacement[0](1), -1e-2) << "the weak one has fallen";
  std::array<double, 1> value{};
  probes.sample(simulation, value);
  EXPECT_NEAR(value[0], -pressure, 1e-3 * pressure);
}

TEST(SharedEdge, RefusesAPointWhereTheBlocksDoNotTouch) {
  for (const Vec2& point : {Vec2(2, 0), Vec2(0.5, 0.1), Vec2(0, -0.5)}) {
    Model model = pulled_box(3, 0.1, 10);
    model.measurements.resize(1);
    model.measurements[0].point = point;
    model.measurements[0].block = point.y() > 0 ? 1 : 0;
    model.measurements[0].other_block = point.y() > 0 ? 0 : 1;
    const Simulation simulation = simulation_of(std::move(model));
    EXPECT_THROW(Probes{simulation}, InputError) << point.transpose();
  }
}

}  // namespace
}  // namespace dda
