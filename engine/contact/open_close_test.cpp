#include "dda/contact/open_close.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "dda/contact/contact_models.h"
#include "dda/contact/contact_set.h"

namespace dda {
namespace {

constexpr double normal_spring = 100;
constexpr double shear_spring = 40;
constexpr double round_off = 1e-13;
constexpr double friction_tolerance = 1e-9;

InterfaceElement classical_element() {
  InterfaceElement element;
  element.law = InterfaceLaw::classical;
  element.length = 2;
  element.stiffness << normal_spring, shear_spring, normal_spring, shear_spring;
  return element;
}

// Judges the end `from` once, from the given start, while `to` stays pressed.
struct Judged {
  bool again;
  InterfaceState state;
};
Judged judge_first_end(const EndStrength& strength, InterfaceState start, double normal_gap, double shear_gap) {
  start.gap(2) = -1;
  start.force(2) = -normal_spring;
  const Vec4 change(normal_gap - start.gap(0), shear_gap - start.gap(1), 0, 0);
  InterfaceState trial = start;
  const bool again =
      judge(classical_element(), strength, start, change, Vec3::Zero(), Vec3::Zero(), friction_tolerance, trial);
  return {again, trial};
}

InterfaceState start_with(bool broken, ContactStatus status = ContactStatus::locked) {
  InterfaceState start;
  start.broken[0] = broken;
  start.status[0] = status;
  return start;
}

struct Case {
  std::string name;
  EndStrength strength;  // N/m: tension, cohesion, tangent of the friction angle
  bool was_broken;
  double normal_gap, shear_gap;  // times 100 and 40 N/m
  ContactStatus status;
  bool is_broken;
  double normal_force, shear_force;
};

class MohrCoulomb : public testing::TestWithParam<Case> {};

constexpr ContactStatus locked = ContactStatus::locked;
constexpr ContactStatus sliding = ContactStatus::sliding;
constexpr ContactStatus open = ContactStatus::open;
const EndStrength joint{5, 3, 0.5};
const EndStrength no_strength{0, 0, 0.5};
const EndStrength smooth{0, 0, 0};

INSTANTIATE_TEST_SUITE_P(
    OpenClose, MohrCoulomb,
    testing::Values(
        Case{"tension_below_strength", joint, false, 0.04, 0, locked, false, 4, 0},
        Case{"tension_above_strength", joint, false, 0.06, 0, open, true, 0, 0},
        Case{"broken_carries_no_tension", joint, true, 0.04, 0, open, true, 0, 0},
        Case{"shear_below_cohesion", joint, false, 0, 0.07, locked, false, 0, 2.8},
        Case{"shear_above_cohesion_without_pressure_opens", joint, false, 0, 0.08, open, true, 0, 0},
        Case{"tension_lowers_shear_strength", joint, false, 0.02, 0.06, open, true, 0, 0},  // 3 - 0.5 * 2 < 2.4
        Case{"pressure_raises_shear_strength", joint, false, -0.04, 0.12, locked, false, -4, 4.8},
        Case{"shear_above_strength_slides_at_the_residual", joint, false, -0.04, 0.13, sliding, true, -4, 2},
        Case{"slides_the_other_way", joint, false, -0.04, -0.13, sliding, true, -4, -2},
        Case{"broken_sticks_below_friction", joint, true, -0.04, 0.049, locked, true, -4, 1.96},
        Case{"broken_slides_above_friction", joint, true, -0.04, 0.051, sliding, true, -4, 2},
        Case{"friction_alone_sticks", no_strength, false, -0.04, 0.049, locked, false, -4, 1.96},
        Case{"friction_alone_slides", no_strength, false, -0.04, 0.06, sliding, true, -4, 2},
        Case{"no_strength_opens_at_once", no_strength, false, 1e-12, 0, open, true, 0, 0},
        Case{"at_rest_nothing_breaks", no_strength, false, 0, 0, locked, false, 0, 0},
        Case{"smooth_slides_freely", smooth, false, -0.04, 0.5, sliding, true, -4, 0}),
    [](const auto& each) { return each.param.name; });

TEST_P(MohrCoulomb, StatusAndForces) {
  const Case& given = GetParam();
  const Judged judged =
      judge_first_end(given.strength, start_with(given.was_broken), given.normal_gap, given.shear_gap);
  EXPECT_EQ(judged.state.status[0], given.status);
  EXPECT_EQ(judged.state.broken[0], given.is_broken);
  EXPECT_NEAR(judged.state.force(0), given.normal_force, round_off);
  EXPECT_NEAR(judged.state.force(1), given.shear_force, round_off);
  EXPECT_EQ(judged.again, given.status != locked);  // from locked
  EXPECT_DOUBLE_EQ(judged.state.gap(0), given.normal_gap);
  // The elastic part of the tangential gap carries the shear; the rest is slip.
  EXPECT_NEAR(judged.state.gap(1) * shear_spring, given.shear_force, round_off);
  const double slip = given.status == sliding ? given.shear_gap - given.shear_force / shear_spring : 0;
  EXPECT_NEAR(judged.state.slip[0], slip, round_off);
  // The other end is pressed and not touched by any of this.
  EXPECT_EQ(judged.state.status[1], locked);
  EXPECT_EQ(judged.state.force(2), -normal_spring);
}

TEST(OpenClose, BondedNeverBreaks) {
  JointMaterial bonded;
  bonded.bonded = true;
  const Judged judged = judge_first_end(end_strength(bonded, 2), start_with(false), 1e9, -1e9);
  EXPECT_FALSE(judged.again);
  EXPECT_EQ(judged.state.status[0], locked);
}

TEST(OpenClose, StrengthIsSharedByTheEnds) {
  JointMaterial rough;
  rough.friction_angle = std::numbers::pi / 6;
  rough.cohesion = 7;
  rough.tensile_strength = 3;
  const EndStrength strength = end_strength(rough, 4);
  EXPECT_DOUBLE_EQ(strength.tension, 6);
  EXPECT_DOUBLE_EQ(strength.cohesion, 14);
  EXPECT_NEAR(strength.friction, 1 / std::sqrt(3.0), round_off);
}

TEST(OpenClose, ClosesAgainWithoutShearOrStrength) {
  const InterfaceState start = start_with(true, open);
  const Judged judged = judge_first_end(joint, start, -0.04, 0);
  EXPECT_TRUE(judged.again);
  EXPECT_EQ(judged.state.status[0], locked);
  EXPECT_TRUE(judged.state.broken[0]);
  EXPECT_NEAR(judged.state.force(0), -4, round_off);
  EXPECT_EQ(judged.state.force(1), 0);
}

TEST(OpenClose, AnEndThatOpensAfterAPassOfSlidingHasNotSlipped) {
  const InterfaceState start = start_with(true);
  InterfaceState trial = judge_first_end(joint, start, -0.04, 0.3).state;
  ASSERT_EQ(trial.status[0], sliding);
  ASSERT_NE(trial.slip[0], 0);
  judge(classical_element(), joint, start, Vec4(0.01, 0.3, 0, 0), Vec3::Zero(), Vec3::Zero(), friction_tolerance,
        trial);
  EXPECT_EQ(trial.status[0], open);
  EXPECT_EQ(trial.slip[0], 0);
}

TEST(OpenClose, SlidingAsksForAnotherPassUntilFrictionSettles) {
  InterfaceState start = start_with(true, sliding);
  start.force(1) = 2;  // friction of the previous pass
  EXPECT_FALSE(judge_first_end(joint, start, -0.04, 0.3).again);
  start.force(1) = 2.1;
  EXPECT_TRUE(judge_first_end(joint, start, -0.04, 0.3).again);
}

TEST(OpenClose, SpringsWithoutShearStiffnessStayFinite) {
  InterfaceElement element = classical_element();
  element.stiffness(1) = element.stiffness(3) = 0;
  for (const double shear_gap : {0.0, 0.3}) {
    InterfaceState trial = start_with(false);
    const InterfaceState start = trial;
    judge(element, joint, start, Vec4(-0.04, shear_gap, -0.04, 0), Vec3::Zero(), Vec3::Zero(), friction_tolerance,
          trial);
    EXPECT_TRUE(trial.gap.allFinite() && trial.force.allFinite());
    EXPECT_EQ(trial.status[0], locked);
    EXPECT_EQ(trial.force(1), 0);
  }
}

TEST(OpenClose, PointContactJudgesOneEnd) {
  InterfaceElement element = classical_element();
  element.length = 0;
  element.stiffness(2) = element.stiffness(3) = 0;
  InterfaceState start;
  InterfaceState trial = start;
  EXPECT_TRUE(
      judge(element, no_strength, start, Vec4(1, 0, 1, 0), Vec3::Zero(), Vec3::Zero(), friction_tolerance, trial));
  EXPECT_EQ(trial.status[0], open);
  EXPECT_EQ(trial.status[1], locked);
}

TEST(OpenClose, RowsAndForcesOfTheNextPassFollowTheStatuses) {
  InterfaceState start;
  start.gap << -0.04, 0.02, -0.01, 0.03;
  start.force << -4, 0.8, -1, 1.2;
  InterfaceState trial = start;
  const InterfaceElement element = classical_element();
  EXPECT_EQ(active_rows(element, trial), Vec4(1, 1, 1, 1));
  EXPECT_NEAR((force_without_motion(element, start, trial) - start.force).norm(), 0, round_off);
  trial.status = {sliding, open};
  trial.force(1) = 1.9;  // friction of the pass before
  EXPECT_EQ(active_rows(element, trial), Vec4(1, 0, 0, 0));
  EXPECT_NEAR((force_without_motion(element, start, trial) - Vec4(-4, 1.9, 0, 0)).norm(), 0, round_off);
}

// Resultant and moment about the middle of the forces that a classical or consistent interface exerts on block b.
Vec3 resultant(const InterfaceElement& element, const InterfaceState& state) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(12);
  add_interface_force(element, state.force, Vec4::Zero(), force);
  return force.segment<3>(6);
}

TEST(AsClassical, KeepsForcesAndMoment) {
  Model model = model_of({{box_ring(0, 0, 1, 2), {}}, {box_ring(1, 0.5, 2, 3), {}}});
  place(model, 0.6);
  const ContactSet contacts = make_contacts(model);
  const InterfaceElement& consistent = contacts.elements.at(0);
  ASSERT_EQ(consistent.law, InterfaceLaw::consistent);
  InterfaceElement classical = make_element(model, contacts.interfaces[0], InterfaceLaw::classical);
  set_geometry(model, reference_frame(model, contacts.interfaces[0]), classical);
  InterfaceState state;
  state.gap << 0.1, -0.2, 0.03, 0.4;
  state.force << -5, 2, 0.7, 0.4;
  const InterfaceState converted = as_classical(state, classical.stiffness);
  EXPECT_NEAR((resultant(classical, converted) - resultant(consistent, state)).norm(), 0, 1e-12);
  EXPECT_NEAR((elastic_force(classical, converted.gap, Vec3::Zero(), Vec3::Zero()) - converted.force).norm(), 0, 1e-12);
}

TEST(AsClassical, FiniteWithoutShearStiffness) {
  InterfaceState state;
  state.force << -5, 2, 0.7, 0.4;
  EXPECT_TRUE(as_classical(state, Vec4(1, 0, 1, 0)).gap.allFinite());
}

TEST(BeyondStrength, MeanForceAndEitherEnd) {
  const auto beyond = [](const EndStrength& strength, const Vec4& force) {
    InterfaceState state;
    state.force = force;
    return beyond_strength(strength, state);
  };
  EXPECT_FALSE(beyond(joint, Vec4(9.9, 0, 0, 0)));
  EXPECT_TRUE(beyond(joint, Vec4(10.1, 0, 0, 0)));
  EXPECT_FALSE(beyond(joint, Vec4(0, 5.9, 0, 0)));
  EXPECT_TRUE(beyond(joint, Vec4(0, -6.1, 0, 0)));
  // Pressed as a whole but bent open at one end, whichever.
  EXPECT_FALSE(beyond(no_strength, Vec4(-10, 0, 9.9, 0)));
  EXPECT_TRUE(beyond(no_strength, Vec4(-10, 0, 10.1, 0)));
  EXPECT_TRUE(beyond(no_strength, Vec4(-10, 0, -10.1, 0)));
}

TEST(Judge, ConsistentInterfaceFollowsGapAndStress) {
  Model model = model_of({{box_ring(0, 0, 1, 2), {}}, {box_ring(1, 0, 2, 2), {}}});
  const ContactSet contacts = make_contacts(model);
  InterfaceState trial;
  const Vec3 stress_a(3, 0, 1);
  const Vec3 stress_b(5, 0, -2);
  EXPECT_FALSE(
      judge(contacts.elements[0], no_strength, {}, Vec4(1e-9, 0, 0, 0), stress_a, stress_b, friction_tolerance, trial));
  EXPECT_NEAR(trial.force(0), contacts.elements[0].stiffness(0) * 1e-9 + 8, 1e-12);
  EXPECT_NEAR(trial.force(1), -1, 1e-12);
}

}  // namespace
}  // namespace dda
