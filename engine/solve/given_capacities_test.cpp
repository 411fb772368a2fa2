// Steps whose friction is given by their start: convex problems, with one answer wherever the way to it begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "engine/solve/given_friction_problems.h"

namespace dda {
namespace {

constexpr double normal_spring = HandMadeProblem::normal_spring;
constexpr double shear_spring = HandMadeProblem::shear_spring;

// Pressed by 40 N at the start and by 120 N at the end of the step: friction is that of 40 N.
TEST(GivenCapacities, FrictionIsThatOfTheStart) {
  HandMadeProblem made = block_on_floor({100, -100});
  press(-0.1, made.states[0]);
  made.rule.capacity_is_given = true;
  const SolvedStep solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  const Vec2 moved = solved.solver.increment().segment<2>(6);
  EXPECT_NEAR(moved.x(), (100 - 0.5 * 40) / 100, 1e-10);
  EXPECT_NEAR(moved.y(), -100 / (100 + normal_spring), 1e-10);
  EXPECT_NEAR(solved.solver.contacts()[0].force(0), -120, 1e-8);
}

// The laws by hand. Given friction is that of ends which open, too, or the problem would not be convex.
auto law_of(const HandMadeProblem& made) {
  return [&made](std::size_t k, const Vec4& gap) {
    const double capacity = -made.strengths[k].friction * made.states[k].force(0);
    Vec4 force = Vec4::Zero();
    force(0) = normal_spring * std::min(0.0, gap(0));
    force(1) = std::clamp(shear_spring * gap(1), -capacity, capacity);
    return force;
  };
}

TEST(GivenCapacities, HeapsHaveOneAnswerWhereverTheWayBegins) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const HandMadeProblem made = heap(seed);
    expect_one_answer(made, seed, law_of(made));
  }
}

// What interior passes alone leave, and how many they are: a dozen or two, with friction and without.
TEST(GivenCapacities, InteriorPassesComeToTheAnswerByThemselves) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap(seed);
    if (seed % 4 == 0)
      for (EndStrength& strength : made.strengths) strength.friction = 0;
    const FromInside inside(made);
    ASSERT_TRUE(inside.arrived) << seed;
    const double largest = inside.at.contacts.largest_force();
    EXPECT_LT(largest_residual(made, inside.at.increment, law_of(made)), 1e-6 * largest) << seed;
    EXPECT_LT(inside.costs.counters.open_close_iterations, 40) << seed;
  }
}

}  // namespace
}  // namespace dda
