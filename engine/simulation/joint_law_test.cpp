// Joints that fail: a direct shear test with peak, residual and dilation, against its closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double pressure = 2e6;  // Pa, on a joint of 1 m

JointMaterial rough_joint() {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = 40 * degree;
  joint.cohesion = 1e6;
  joint.tensile_strength = 5e5;
  joint.residual_friction_angle = 30 * degree;
  joint.residual_cohesion = 2e5;
  return joint;
}

// A box of 1 m on a wider one: pressed from above, and pulled along at its lower corners, so that the reaction has no
// moment about the joint. The tangent of the joint points to the left.
Model shear_box(const JointMaterial& joint, double pull, int steps, Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  model.blocks = {rectangle("base", -1, -1, 3, 1), rectangle("box", 0, 0, 1, 0.5)};
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(2, -1), Vec2(-1, 0), Vec2(2, 0)})
    model.supports.push_back({0, corner, true, true, 1e13, Vec2::Zero(), Constant{}});
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0)})
    model.supports.push_back({1, corner, true, false, 1e13, {pull, 0}, PiecewiseLinear{{0, 1.0 * steps}, {0, 1}}});
  model.edge_loads = {{1, {1, 0.5}, {0, 0.5}, {0, -pressure}, Constant{}}};
  model.stages = {stage_of(static_integrator(), 1, steps, kinematics)};
  return model;
}

// Sums up the joint's forces, N per m of thickness: compression positive, shear against the motion positive.
Vec2 joint_force(const Simulation& simulation) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < simulation.contacts().elements.size(); ++i) {
    const InterfaceElement& element = simulation.contacts().elements[i];
    const Vec4 force = simulation.interface_state(i).force;
    sum += force.head<2>();
    if (element.length > 0) sum += force.tail<2>();
  }
  return {-sum(0), std::abs(sum(1))};
}

double mean_slip(const Simulation& simulation) {
  double sum = 0;
  double ends = 0;
  for (std::size_t i = 0; i < simulation.contacts().elements.size(); ++i) {
    const int count = simulation.contacts().elements[i].length > 0 ? 2 : 1;
    for (int end = 0; end < count; ++end) sum += simulation.interface_state(i).slip[static_cast<std::size_t>(end)];
    ends += count;
  }
  return std::abs(sum / ends);
}

class ShearBox : public testing::TestWithParam<Kinematics> {};
INSTANTIATE_TEST_SUITE_P(JointLaw, ShearBox, testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& each) { return each.param == Kinematics::small ? "small" : "finite"; });

TEST_P(ShearBox, RisesToItsPeakAndFallsToItsResidual) {
  constexpr int steps = 400;
  constexpr double pull = 4e-4;
  const JointMaterial joint = rough_joint();
  const double peak = joint.cohesion + pressure * std::tan(joint.friction_angle);
  const double residual = joint.residual_cohesion + pressure * std::tan(*joint.residual_friction_angle);
  Simulation simulation = simulation_of(shear_box(joint, pull, steps, GetParam()));
  double largest = 0;
  double before = 0;
  double largest_rise = 0;
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const Vec2 force = joint_force(simulation);
    EXPECT_NEAR(force(0), pressure, 1e-6 * pressure);
    largest = std::max(largest, force(1));
    largest_rise = std::max(largest_rise, force(1) - before);
    before = force(1);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), GetParam() == Kinematics::small ? 1e-11 : 1e-5);
  }
  // The peak is seen at the end of steps only: it may be missed by less than what one step adds.
  EXPECT_LE(largest, peak * (1 + 1e-9));
  EXPECT_GT(largest, peak - 1.01 * largest_rise);
  EXPECT_LT(largest_rise, 0.05 * peak);
  // Capacities follow normal forces to 1e-10. What remains is the length of the joint, which grows with the strains,
  // and in finite kinematics its direction: 1e-3 at most.
  EXPECT_NEAR(before, residual, 1e-3 * residual);
  EXPECT_GT(mean_slip(simulation), 1e-4);
}

// A consistent joint passes on its blocks' stress and needs no overlap for it. When it breaks, springs take over, and
// the pressure on the joint stays what it was: in a tenth of a millisecond no wave goes up and down the box. (Measured
// 0.5 %.)
TEST(JointLaw, PressureOutlivesAJointThatBreaks) {
  JointMaterial joint = rough_joint();
  joint.law = InterfaceLaw::consistent;
  Model model = shear_box(joint, 0, 1, Kinematics::finite);
  for (Block& block : model.blocks) block.initial_stress = {0, -pressure, 4e6};
  model.stages = {stage_of(generalized_alpha_integrator(0.8), 2e-6, 60, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    EXPECT_NEAR(joint_force(simulation)(0), pressure, 0.05 * pressure);
  }
  for (const InterfaceState& state : simulation.contacts().states) EXPECT_TRUE(state.broken[0]);
}

// A dry joint with a residual friction: peak until it first slides.
TEST_P(ShearBox, ADryJointHasItsPeakUntilItSlides) {
  constexpr int steps = 200;
  JointMaterial joint = rough_joint();
  joint.cohesion = joint.tensile_strength = joint.residual_cohesion = 0;
  Simulation simulation = simulation_of(shear_box(joint, 3e-4, steps, GetParam()));
  double largest = 0;
  double before = 0;
  double largest_rise = 0;
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    largest = std::max(largest, joint_force(simulation)(1));
    largest_rise = std::max(largest_rise, joint_force(simulation)(1) - before);
    before = joint_force(simulation)(1);
  }
  EXPECT_LE(largest, pressure * std::tan(40 * degree) * (1 + 1e-9));
  EXPECT_GT(largest, pressure * std::tan(40 * degree) - 1.01 * largest_rise);
  EXPECT_LT(largest_rise, 0.05 * largest);
  EXPECT_NEAR(before, pressure * std::tan(30 * degree), 1e-3 * before);
}

// ---- Dilation.

JointMaterial rising_joint(double zero_dilation_slip) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = 35 * degree;
  joint.dilation_angle = 10 * degree;
  joint.zero_dilation_slip = zero_dilation_slip;
  return joint;
}

double height(const Simulation& simulation) { return simulation.state().displacement[1](1); }

// Steps until the joint has slid.
void step_until_sliding(Simulation& simulation) {
  while (!simulation.finished() && mean_slip(simulation) == 0)
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

TEST_P(ShearBox, DilationLiftsTheBoxBySlipTimesItsTangent) {
  Simulation simulation = simulation_of(shear_box(rising_joint(1), 4e-3, 200, GetParam()));
  step_until_sliding(simulation);
  const double ground = height(simulation) - mean_slip(simulation) * std::tan(10 * degree);
  double slip = 0;
  while (!simulation.finished()) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    slip = mean_slip(simulation);
    // The load stays, so all springs keep their lengths but for the box' inertia, which lifting it by 4e-6 m in the
    // step of 1 s adds: 1300 kg * 4e-6 m/s2 over springs of 2e10 N/m. In finite kinematics the box turns with the shear
    // of the base, by less than 1e-3 of what it slides.
    const double tolerance = GetParam() == Kinematics::small ? 1e-11 : 1e-3 * slip;
    ASSERT_NEAR(height(simulation) - ground, slip * std::tan(10 * degree), tolerance);
    ASSERT_NEAR(joint_force(simulation)(0), pressure, 1e-6 * pressure);
    ASSERT_NEAR(joint_force(simulation)(1), pressure * std::tan(35 * degree), 2e-3 * pressure);
  }
  EXPECT_GT(slip, 3e-3);
}

// Stages without dt, each of which moves the base: out, back to where the box began, out on the other side and back.
// The box stays where it is but for the springs that hold it, and rides on the joint.
TEST_P(ShearBox, DilationComesDownOnTheWayBackInStagesThatFindTheirSteps) {
  const double way = 0.02;
  const std::vector<double> path{0, 1, 1.5, 1, 0.5, 0, -0.5, 0};
  for (const double degrees : {2.0, 10.0, 25.0}) {
    Model model = shear_box(rising_joint(1), 0, 1, GetParam());
    model.joints[0].dilation_angle = degrees * degree;
    model.supports.erase(model.supports.begin(), model.supports.begin() + 4);
    HeldBlock base;
    base.amplitude = {way, 0};
    PiecewiseLinear table;
    for (std::size_t i = 0; i < path.size(); ++i) {
      table.times.push_back(static_cast<double>(i));
      table.values.push_back(path[i]);
    }
    base.history = table;
    model.held_blocks = {base};
    Stage stage = stage_of(static_integrator(), 0, 1, GetParam());
    stage.duration = 1;
    stage.equilibrium = 1e-6;
    model.stages.assign(path.size() - 1, stage);
    for (std::size_t i = 0; i < model.stages.size(); ++i) model.stages[i].name = std::to_string(i);
    Simulation simulation = simulation_of(std::move(model));
    std::vector<double> heights{0};  // at the ends of stages, before the first of which nothing presses
    simulation.watch().at_end = [&] { heights.push_back(height(simulation)); };
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    ASSERT_EQ(heights.size(), path.size());
    // With friction one way and the other the box leans on one corner more, and on the other: within a half of what its
    // springs are closed by when it is back where it began. (The descents that were lost are up to 50 times as much.)
    const double closed = -heights[5];
    EXPECT_LT(closed, 1e-3);
    for (std::size_t i = 1; i < path.size(); ++i)
      EXPECT_NEAR(heights[i] + closed, std::abs(path[i]) * way * std::tan(degrees * degree), closed / 2)
          << degrees << ", stage " << i;
  }
}

TEST_P(ShearBox, DilationEndsAtItsSlip) {
  Simulation simulation = simulation_of(shear_box(rising_joint(1e-3), 4e-3, 200, GetParam()));
  step_until_sliding(simulation);
  const double ground = height(simulation) - mean_slip(simulation) * std::tan(10 * degree);
  run(simulation, 200 - static_cast<int>(simulation.state().step));
  EXPECT_GT(mean_slip(simulation), 3e-3);
  EXPECT_NEAR(height(simulation) - ground, 1e-3 * std::tan(10 * degree),
              GetParam() == Kinematics::small ? 1e-12 : 1e-6);
}

// Lifting the load is that part of the work against friction which is no loss.
TEST(Dilation, LedgerCountsAsFrictionWhatIsLost) {
  for (const Integrator& integrator : {static_integrator(), thesis_integrator(), generalized_alpha_integrator(0.5)}) {
    Model model = shear_box(rising_joint(1), 4e-3, 200, Kinematics::small);
    model.stages[0].integrator = integrator;
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 100);
    const double lost = simulation.energy().friction;
    const double slip = mean_slip(simulation);
    for (int i = 0; i < 100; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      // Each step leaves forces that still change by up to 1e-10.
      ASSERT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << integrator.name;
    }
    const double slid = mean_slip(simulation) - slip;
    EXPECT_GT(slid, 1e-3);
    const double expected = pressure * (std::tan(35 * degree) - std::tan(10 * degree)) * slid;
    EXPECT_NEAR(simulation.energy().friction - lost, expected, 1e-6 * expected) << integrator.name;
  }
}

// Held at its height by a lid, a joint that dilates presses itself together: constant stiffness above instead of a
// constant load. The fixed point over the dilations must find the balance of shear, pull and lift.
TEST_P(ShearBox, DilationAgainstAStiffLid) {
  Model model = shear_box(rising_joint(1), 4e-4, 100, GetParam());
  model.supports.push_back({1, {0, 0.5}, false, true, 1e9, Vec2::Zero(), Constant{}});
  model.supports.push_back({1, {1, 0.5}, false, true, 1e9, Vec2::Zero(), Constant{}});
  Simulation simulation = simulation_of(std::move(model));
  step_until_sliding(simulation);
  const double force_before = joint_force(simulation)(0);
  const double slip_before = mean_slip(simulation);
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  const Vec2 force = joint_force(simulation);
  const double lift = (mean_slip(simulation) - slip_before) * std::tan(10 * degree);
  EXPECT_NEAR(force(1), std::tan(35 * degree) * force(0), 1e-3 * force(1));
  // The lift closes the lid, the springs and the box together: 2e9, 2e10 and 2e9 N/m, in series.
  EXPECT_NEAR(force(0) - force_before, lift / (1 / 2e9 + 1 / 2e10 + 1 / 2e9), 0.1 * (force(0) - force_before));
}

// ---- History.

TEST(JointLaw, GoesOnToTheLastBitAfterASnapshot) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    JointMaterial joint = rough_joint();
    joint.dilation_angle = 5 * degree;
    joint.zero_dilation_slip = 2e-4;
    const Model model = shear_box(joint, 1e-3, 100, kinematics);
    Simulation whole = simulation_of(model);
    run(whole, 60);
    ASSERT_TRUE(whole.interface_state(0).residual[0]);
    ASSERT_GT(whole.interface_state(0).dilation[0], 0);
    Simulation resumed = simulation_of(model);
    restore(resumed, whole.state(), save(whole));
    run(whole, 40);
    run(resumed, 40);
    for (std::size_t i = 0; i < whole.state().displacement.size(); ++i)
      EXPECT_EQ(whole.state().displacement[i], resumed.state().displacement[i]);
    EXPECT_EQ(whole.energy().friction, resumed.energy().friction);
    EXPECT_EQ(whole.interface_state(0).dilation, resumed.interface_state(0).dilation);
    EXPECT_EQ(whole.interface_state(0).residual, resumed.interface_state(0).residual);
    EXPECT_EQ(whole.deepest_penetration().depth, resumed.deepest_penetration().depth);
    EXPECT_GT(whole.deepest_penetration().depth, 0);
  }
}

}  // namespace
}  // namespace dda
