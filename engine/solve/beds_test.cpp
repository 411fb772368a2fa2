// Steps whose blocks meet along stretches of the projected law: heaps drawn by lot, some of whose stretches gape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>

#include "engine/contact/projected_law.h"
#include "engine/solve/given_friction_problems.h"

namespace dda {
namespace {

constexpr double normal_spring = HandMadeProblem::normal_spring;
constexpr double shear_spring = HandMadeProblem::shear_spring;

// Makes a contact a stretch of the projected law, `length` long, that lies level between its blocks.
void lay_on_bed(double length, double lever, double spread, InterfaceElement& element) {
  element.law = InterfaceLaw::projected;
  element.length = length;
  element.lever = lever;
  element.spread = spread;
  element.stiffness.tail<2>() = element.stiffness.head<2>();
  for (Mat46* rows : {&element.rows_a, &element.rows_b}) {
    const Mat26 middle = rows->topRows<2>();
    Mat26 along = Mat26::Zero();  // the way along the joint turns with the block
    along(0, 2) = (rows == &element.rows_b ? -1 : 1) * lever * length / 2;
    rows->topRows<2>() = middle - along;
    rows->bottomRows<2>() = middle + along;
  }
}

// The heap with stretches in place of one in `every` of its corners, some of which gape when the step begins.
HandMadeProblem heap_of_stretches(unsigned seed, std::size_t every = 2) {
  HandMadeProblem made = heap(seed);
  std::mt19937_64 random(1000 + seed);
  for (std::size_t k = 0; k < made.elements.size(); k += every) {
    InterfaceElement& element = made.elements[k];
    InterfaceState& state = made.states[k];
    lay_on_bed(drawn_between(random, 0.2, 1), drawn_between(random, 0.3, 0.57), drawn_between(random, 0.1, 1), element);
    state.gap(2) = drawn_between(random, -0.2, 0.2);
    const BedAnswer bed = press_bed(bed_of(element), {state.gap(0), state.gap(2)});
    state.force << bed.force(0), 0, bed.force(1), 0;
  }
  return made;
}

// The laws by hand, friction being that of the start unless it follows the forces.
auto law_of(const HandMadeProblem& made, bool friction_follows = false) {
  return [&made, friction_follows](std::size_t k, const Vec4& gap) {
    const InterfaceElement& element = made.elements[k];
    const InterfaceState& start = made.states[k];
    Vec4 force = Vec4::Zero();
    const bool on_bed = press_together(element, start.broken);
    const BedAnswer bed = on_bed ? press_bed(bed_of(element), {gap(0), gap(2)}) : BedAnswer();
    for (int end = 0; end < ends_of(element); ++end)
      force(2 * end) = on_bed ? bed.force(end) : normal_spring * std::min(0.0, gap(2 * end));
    const Vec4 pressing = friction_follows ? force : start.force;
    for (int end = 0; end < ends_of(element); ++end) {
      const double capacity = made.strengths[k].capacity(pressing_force(pressing, end), false);
      force(2 * end + 1) = std::clamp(shear_spring * gap(2 * end + 1), -capacity, capacity);
    }
    return force;
  };
}

// Counts stretches of which one end is open.
int stretches_that_gape(const HandMadeProblem& made, const Iterate& at) {
  int gape = 0;
  for (std::size_t k = 0; k < made.elements.size(); k += 2) {
    const OpenEnds open = open_ends(made.elements[k].lever, {at.contacts[k].gap(0), at.contacts[k].gap(2)});
    if (open.first != open.second) ++gape;
  }
  return gape;
}

TEST(StretchesOnBeds, InteriorPassesLeadToTheAnswerOfGivenFriction) {
  int gape = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const HandMadeProblem made = heap_of_stretches(seed);
    const FromInside inside(made);
    ASSERT_TRUE(inside.arrived) << seed;
    const double largest = inside.at.contacts.largest_force();
    EXPECT_LT(largest_residual(made, inside.at.increment, law_of(made)), 1e-6 * largest) << seed;
    EXPECT_LT(inside.costs.counters.open_close_iterations, 60) << seed;
    gape += stretches_that_gape(made, inside.at);
  }
  EXPECT_GT(gape, 200);  // of some 4,200
}

// Friction here is more than Coulomb's law has a sure answer for, and some ways lead nowhere. Where one arrives the
// balance holds, with the friction of what presses at its end.
TEST(StretchesOnBeds, InteriorPassesLeadToAnAnswerOfCoulombsLaw) {
  int arrived = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap_of_stretches(seed);
    made.rule.capacity_is_given = false;
    const FromInside inside(made);
    if (!inside.arrived) continue;
    ++arrived;
    const double largest = inside.at.contacts.largest_force();
    EXPECT_LT(largest_residual(made, inside.at.increment, law_of(made, true)), 1e-6 * largest) << seed;
  }
  EXPECT_GE(arrived, 195);  // 199
}

// A way inside begins as far from the edges as what the beds store and what the loads do amount to. Here no load is
// left, as in rock that has all but settled.
TEST(StretchesOnBeds, WhatTheyStoreIsEnoughToBeginFromInside) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    HandMadeProblem made = heap_of_stretches(seed, 1);
    made.rhs.setZero();
    const FromInside inside(made);
    ASSERT_TRUE(inside.arrived) << seed;
    const double largest = inside.at.contacts.largest_force();
    EXPECT_LT(largest_residual(made, inside.at.increment, law_of(made)), 1e-6 * largest) << seed;
  }
}

// Blocks so light that those which come loose turn by a million times what their joints close, on next to nothing of
// them. Ways from inside then end a little off what these beds answer, and quick passes go on from there.
TEST(StretchesOnBeds, MayTurnOnNextToNothing) {
  int turned = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap_of_stretches(seed, 1);
    std::mt19937_64 random(seed);
    for (int b = 1; b < made.base.size(); ++b) {
      made.base.diagonal(b).topLeftCorner<3, 3>() *= 1e-4;
      made.rhs(6 * b + 2) = drawn_between(random, -60, 60);
    }
    const SolvedStep solved(made);
    ASSERT_EQ(solved.solution.status, Status::ok) << seed;
    const double largest = solved.solver.contacts().largest_force();
    // Round-off of gaps of a thousand metres and more: 1.2e-8 at most, 8.6e-9 where gaps were sums of steps.
    EXPECT_LT(largest_residual(made, solved.solver.increment(), law_of(made)), 3e-8 * largest) << seed;
    EXPECT_LT(solved.costs.counters.open_close_iterations, 100) << seed;  // 80 at most; 144 with cut steps
    for (std::size_t k = 0; k < made.elements.size(); ++k) {
      const InterfaceTrial& trial = solved.solver.contacts()[k];
      if (trial.force(0) + trial.force(2) < 0 && std::abs(trial.gap(2) - trial.gap(0)) > 1e3) ++turned;
    }
  }
  EXPECT_GE(turned, 5);  // 9; round-off may have a say
}

TEST(StretchesOnBeds, HaveOneAnswerUnderGivenFriction) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const HandMadeProblem made = heap_of_stretches(seed);
    expect_one_answer(made, seed, law_of(made));
  }
}

}  // namespace
}  // namespace dda
