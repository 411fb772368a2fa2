#include "engine/contact/open_close.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/make_element.h"
#include "engine/contact/open_close_models.h"

namespace dda {
namespace {

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
        Case{"smooth_slides_freely", smooth, false, -0.04, 0.5, sliding, true, -4, 0},
        Case{"bond_holds_up_to_its_peak", weakening, false, -0.04, 0.124, locked, false, -4, 4.96},
        Case{"bond_beyond_its_peak_has_the_residual", weakening, false, -0.04, 0.126, sliding, true, -4, 1.8},
        Case{"bond_pulled_apart_opens", weakening, false, 0.06, 0.01, open, true, 0, 0},
        Case{"dry_holds_up_to_its_peak", dry_weakening, true, -0.04, 0.049, locked, true, -4, 1.96},
        Case{"dry_beyond_its_peak_has_the_residual", dry_weakening, true, -0.04, -0.051, sliding, true, -4, -1.2}),
    [](const auto& each) { return each.param.name; });

TEST_P(MohrCoulomb, StatusAndForces) {
  const Case& given = GetParam();
  const InterfaceState state = step_to(given.strength, start_with(given.was_broken), given.normal_gap, given.shear_gap);
  EXPECT_EQ(state.status[0], given.status);
  EXPECT_EQ(state.broken[0], given.is_broken);
  EXPECT_NEAR(state.force(0), given.normal_force, round_off);
  EXPECT_NEAR(state.force(1), given.shear_force, round_off);
  EXPECT_DOUBLE_EQ(state.gap(0), given.normal_gap);
  // The elastic part of the tangential gap carries the shear; the rest is slip.
  EXPECT_NEAR(state.gap(1) * shear_spring, given.shear_force, round_off);
  const double slip = given.status == sliding ? given.shear_gap - given.shear_force / shear_spring : 0;
  EXPECT_NEAR(state.slip[0], slip, round_off);
  // The other end is pressed and not touched by any of this.
  EXPECT_EQ(state.status[1], locked);
  EXPECT_EQ(state.force(2), -normal_spring);
}

// Shear force at which an end slides to a side, and what it gains for each metre: the line through its capacity at its
// reference slip, never below zero.
std::pair<double, double> yield_towards(const InterfaceTrial& trial, std::size_t end, double side) {
  const double ahead = side * trial.reference[end];
  if (trial.capacity[end] == 0 || side * trial.slip[end] < 0) return {trial.capacity[end], 0};
  const double hardening =
      ahead > 0 ? std::min(trial.hardening[end], trial.capacity[end] / ahead) : trial.hardening[end];
  return {ahead > 0 ? trial.capacity[end] - hardening * ahead : trial.capacity[end], hardening};
}

// The potential whose gradient the forces are, written out: half parabolas and Huber's function.
double potential(const InterfaceElement& element, const InterfaceTrial& trial, const Vec4& gap) {
  double energy = 0;
  for (int end = 0; end < 2; ++end) {
    const auto e = static_cast<std::size_t>(end);
    const double above = gap(2 * end) - trial.dilation[e];
    const double normal = trial.broken[e] ? std::min(above, 0.0) : above;
    energy += element.stiffness(2 * end) * normal * normal / 2;
    const double k = element.stiffness(2 * end + 1);
    const double slide = std::abs(gap(2 * end + 1));
    const auto [yield, hardening] = yield_towards(trial, e, gap(2 * end + 1) < 0 ? -1 : 1);
    const double first = yield / k;  // the gap at which it slides
    const double series = k * hardening / (k + hardening);
    energy += !trial.broken[e] || slide < first
                  ? k * slide * slide / 2
                  : k * first * first / 2 + yield * (slide - first) + series * (slide - first) * (slide - first) / 2;
  }
  return energy;
}

class RandomTrials : public testing::Test {
 protected:
  double number(double lower, double upper) { return std::uniform_real_distribution<>(lower, upper)(generator_); }
  Vec4 gaps() { return {number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)}; }

  InterfaceTrial trial() {
    InterfaceTrial trial;
    for (std::size_t end = 0; end < 2; ++end) {
      trial.broken[end] = number(0, 1) < 0.8;
      trial.capacity[end] = std::max(0.0, number(-5, 40));
      trial.dilation[end] = number(-0.5, 0.5);
      trial.hardening[end] = std::max(0.0, number(-60, 60));
      trial.reference[end] = number(-0.3, 0.3);
      trial.slip[end] = number(-1, 1);
    }
    return trial;
  }

  static Vec4 force_at(const InterfaceElement& element, InterfaceTrial trial, const Vec4& gap) {
    trial.gap = gap;
    respond(element, trial);
    return trial.force;
  }

 private:
  std::mt19937 generator_{1};
};

TEST_F(RandomTrials, ForceIsTheGradientOfAPotential) {
  const InterfaceElement element = classical_element();
  constexpr double step = 1e-6;
  // Central differences of a piecewise quadratic: exact within a piece; a kink within the step adds k step/2, and the
  // subtraction round-off eps * 100 J / step.
  constexpr double tolerance = normal_spring * step + 1e-7;
  for (int i = 0; i < 2000; ++i) {
    const InterfaceTrial given = trial();
    const Vec4 gap = gaps();
    const Vec4 force = force_at(element, given, gap);
    for (int row = 0; row < 4; ++row) {
      const Vec4 change = step * Vec4::Unit(row);
      const double slope =
          (potential(element, given, gap + change) - potential(element, given, gap - change)) / (2 * step);
      ASSERT_NEAR(force(row), slope, tolerance);
    }
  }
}

TEST_F(RandomTrials, ThePotentialIsConvex) {
  const InterfaceElement element = classical_element();
  for (int i = 0; i < 5000; ++i) {
    const InterfaceTrial given = trial();
    const Vec4 first = gaps();
    const Vec4 second = i % 2 == 0 ? gaps() : Vec4(first + 1e-3 * gaps());
    const Vec4 difference = force_at(element, given, first) - force_at(element, given, second);
    for (int row = 0; row < 4; ++row) ASSERT_GE(difference(row) * (first(row) - second(row)), 0);
  }
}

TEST_F(RandomTrials, ForceAlongAStepIsThatReachedThere) {
  const InterfaceElement element = classical_element();
  for (int i = 0; i < 2000; ++i) {
    InterfaceTrial given = trial();
    given.gap = gaps();
    given.direction = gaps();
    const double share = number(0, 1);
    const Vec4 force = force_at(element, given, given.gap + share * given.direction);
    // Sums of four products of up to 200 N/m.
    ASSERT_NEAR(force_along(element, given, share), given.direction.dot(force), 1e-12);
  }
}

// The rows said to be active are those whose force changes with the gap.
TEST_F(RandomTrials, ActiveRowsCarryTheStiffness) {
  const InterfaceElement element = classical_element();
  constexpr double step = 1e-9;
  int inactive = 0;
  for (int i = 0; i < 2000; ++i) {
    InterfaceTrial given = trial();
    given.gap = gaps();
    respond(element, given);
    for (int row = 0; row < 4; ++row) {
      const Vec4 moved = force_at(element, given, given.gap + step * Vec4::Unit(row));
      // Round-off of forces of up to 100 N/m over the step.
      ASSERT_NEAR((moved(row) - given.force(row)) / step, given.active(row) * element.stiffness(row), 1e-4);
      inactive += given.active(row) == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(inactive, 1000);
}

TEST(OpenClose, BondedNeverBreaks) {
  JointMaterial bonded;
  bonded.bonded = true;
  const InterfaceState state = step_to(end_strength(bonded, 2), start_with(false), 1e9, -1e9);
  EXPECT_EQ(state.status[0], locked);
  EXPECT_FALSE(state.broken[0]);
  EXPECT_EQ(state.force(0), 1e9 * normal_spring);
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
  InterfaceState state = step_to(joint, start_with(false), -0.04, 0.12);
  ASSERT_NE(state.force(1), 0);
  state = step_to(joint, state, 0.06, 0.3);
  ASSERT_EQ(state.status[0], open);
  state = step_to(joint, state, -0.04, state.gap(1));
  EXPECT_EQ(state.status[0], locked);
  EXPECT_TRUE(state.broken[0]);
  EXPECT_NEAR(state.force(0), -4, round_off);
  EXPECT_EQ(state.force(1), 0);
}

TEST(OpenClose, AnEndThatOpensAfterAPassOfSlidingHasNotSlipped) {
  const InterfaceElement element = classical_element();
  const InterfaceState start = start_with(true);
  InterfaceTrial trial = start_trial(element, joint, start);
  trial.gap << -0.04, 0.3, 0, 0;
  settle(element, joint, trial);
  ASSERT_EQ(finish_trial(element, start, trial).status[0], sliding);
  trial.gap << 0.01, 0.3, 0, 0;
  settle(element, joint, trial);
  const InterfaceState state = finish_trial(element, start, trial);
  EXPECT_EQ(state.status[0], open);
  EXPECT_EQ(state.slip[0], 0);
}

TEST(OpenClose, SlipAddsUpOverStepsAndTurnsBack) {
  InterfaceState state = step_to(no_strength, start_with(true), -0.04, 0.06);  // 2 N of friction: 0.05 m elastic
  EXPECT_NEAR(state.slip[0], 0.01, round_off);
  state = step_to(no_strength, state, -0.04, state.gap(1) + 0.03);
  EXPECT_NEAR(state.slip[0], 0.04, round_off);
  state = step_to(no_strength, state, -0.04, state.gap(1) - 0.07);  // back through stick, not yet sliding
  EXPECT_EQ(state.status[0], locked);
  EXPECT_NEAR(state.slip[0], 0.04, round_off);
  EXPECT_NEAR(state.force(1), 2 - 0.07 * shear_spring, round_off);
  state = step_to(no_strength, state, -0.04, state.gap(1) - 0.05);
  EXPECT_EQ(state.status[0], sliding);
  EXPECT_NEAR(state.slip[0], 0.02, round_off);
  EXPECT_NEAR(state.force(1), -2, round_off);
}

TEST(OpenClose, AnEndThatSlidStartsItsNextStepSliding) {
  const InterfaceElement element = classical_element();
  for (const double side : {1.0, -1.0}) {
    InterfaceState state = step_to(no_strength, start_with(true), -0.04, side * 0.06);
    ASSERT_EQ(state.status[0], sliding);
    state.gap(1) *= 1 - 1e-9;  // measured anew
    InterfaceTrial trial = start_trial(element, no_strength, state);
    EXPECT_EQ(trial.active(1), 0);
    EXPECT_NEAR(trial.force(1), side * 2, round_off);
    trial.gap(1) -= side * 0.01;  // turns back: sticks
    respond(element, trial);
    EXPECT_EQ(trial.active(1), 1);
    trial.gap(1) += side * 0.02;  // goes on
    respond(element, trial);
    EXPECT_EQ(trial.active(1), 0);
  }
}

TEST(OpenClose, CapacityFollowsTheNormalForceAndSaysWhatThatChanges) {
  const InterfaceElement element = classical_element();
  InterfaceTrial trial = start_trial(element, no_strength, start_with(true));
  trial.gap << -0.04, 0.3, 0, 0;
  respond(element, trial);
  EXPECT_EQ(trial.force(1), 0);  // not pressed at the start
  EXPECT_NEAR(update_capacity(element, no_strength, trial), 2, round_off);
  EXPECT_NEAR(trial.force(1), 2, round_off);
  EXPECT_EQ(update_capacity(element, no_strength, trial), 0);
}

TEST(OpenClose, SpringsWithoutShearStiffnessStayFinite) {
  InterfaceElement element = classical_element();
  element.stiffness(1) = element.stiffness(3) = 0;
  for (const double shear_gap : {0.0, 0.3}) {
    const InterfaceState start = start_with(false);
    InterfaceTrial trial = start_trial(element, joint, start);
    trial.gap << -0.04, shear_gap, -0.04, 0;
    settle(element, joint, trial);
    const InterfaceState state = finish_trial(element, start, trial);
    EXPECT_TRUE(state.gap.allFinite() && state.force.allFinite());
    EXPECT_EQ(state.status[0], locked);
    EXPECT_EQ(state.force(1), 0);
  }
}

TEST(OpenClose, PointContactHasOneEnd) {
  InterfaceElement element = classical_element();
  element.length = 0;
  element.stiffness(2) = element.stiffness(3) = 0;
  const InterfaceState start;
  InterfaceTrial trial = start_trial(element, no_strength, start);
  trial.gap << 1, 0, 1, 0;
  trial.direction << 0.5, 0, 0.5, 0;
  EXPECT_EQ(force_along(element, trial, 0), 0.5 * normal_spring);
  settle(element, no_strength, trial);
  const InterfaceState state = finish_trial(element, start, trial);
  EXPECT_EQ(state.status[0], open);
  EXPECT_EQ(state.status[1], locked);
  EXPECT_FALSE(state.broken[1]);
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
  const InterfaceElement& consistent = contacts.elements.own().at(0);
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
  using Ends = std::array<bool, 2>;
  EXPECT_EQ(ends_beyond_strength(joint, Vec4(9.9, 0, 0, 0)), (Ends{false, false}));
  EXPECT_EQ(ends_beyond_strength(joint, Vec4(10.1, 0, 0, 0)), (Ends{true, true}));
  EXPECT_EQ(ends_beyond_strength(joint, Vec4(0, 5.9, 0, 0)), (Ends{false, false}));
  EXPECT_EQ(ends_beyond_strength(joint, Vec4(0, -6.1, 0, 0)), (Ends{true, true}));
  // Pressed as a whole but bent open at one end, whichever.
  EXPECT_EQ(ends_beyond_strength(no_strength, Vec4(-10, 0, 9.9, 0)), (Ends{false, false}));
  EXPECT_EQ(ends_beyond_strength(no_strength, Vec4(-10, 0, 10.1, 0)), (Ends{false, true}));
  EXPECT_EQ(ends_beyond_strength(no_strength, Vec4(-10, 0, -10.1, 0)), (Ends{true, false}));
}

TEST(Trial, ConsistentInterfaceIsNeverJudgedByEnds) {
  const Model model = model_of({{box_ring(0, 0, 1, 2), {}}, {box_ring(1, 0, 2, 2), {}}});
  const ContactSet contacts = make_contacts(model);
  ASSERT_TRUE(has_stress_rows(contacts.elements.own().at(0)));
  InterfaceState start;
  start.force << 8, -1, 2, 3;
  InterfaceTrial trial = start_trial(contacts.elements[0], no_strength, start);
  EXPECT_EQ(trial.force, start.force);
  EXPECT_EQ(trial.active, Vec4::Ones());
  trial.gap << 1e-9, 0, 0, 0;
  const InterfaceState state = finish_trial(contacts.elements[0], start, trial);
  EXPECT_EQ(state.gap, trial.gap);
  EXPECT_EQ(state.status[0], locked);
  EXPECT_EQ(state.slip[0], 0);
}

}  // namespace
}  // namespace dda
