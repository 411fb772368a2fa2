// Steps whose friction is given by their start: convex problems, with one answer wherever the way to it begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/contact/contact_set.h"
#include "engine/solve/contact_solver.h"
#include "engine/solve/interior_passes.h"
#include "engine/solve/solve_problems.h"

namespace dda {
namespace {

constexpr double normal_spring = HandMadeProblem::normal_spring;
constexpr double shear_spring = HandMadeProblem::shear_spring;

struct GivenStep {
  explicit GivenStep(const HandMadeProblem& made) : solver(costs) {
    solver.begin(made.base, SolverKind::dense, 1);
    solution = solver.solve(made.problem());
  }

  Costs costs;
  ContactSolver solver;
  StepSolution solution;
};

// Pressed by 40 N at the start and by 120 N at the end of the step: friction is that of 40 N.
TEST(GivenCapacities, FrictionIsThatOfTheStart) {
  HandMadeProblem made = block_on_floor({100, -100});
  press(-0.1, made.states[0]);
  made.rule.capacity_is_given = true;
  const GivenStep solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  const Vec2 moved = solved.solver.increment().segment<2>(6);
  EXPECT_NEAR(moved.x(), (100 - 0.5 * 40) / 100, 1e-10);
  EXPECT_NEAR(moved.y(), -100 / (100 + normal_spring), 1e-10);
  EXPECT_NEAR(solved.solver.contacts()[0].force(0), -120, 1e-8);
}

// The laws by hand, at given increments: what is left of the balance. Given friction is that of ends which open, too,
// or the problem would not be convex.
double largest_residual(const HandMadeProblem& made, const Eigen::VectorXd& d) {
  Eigen::VectorXd left(d.size());
  made.base.multiply(d, left);
  left -= made.rhs;
  for (std::size_t k = 0; k < made.elements.size(); ++k) {
    const Vec4 gap = made.states[k].gap + gap_increment(made.elements[k], d);
    const double capacity = -made.strengths[k].friction * made.states[k].force(0);
    Vec4 force = Vec4::Zero();
    force(0) = normal_spring * std::min(0.0, gap(0));
    force(1) = std::clamp(shear_spring * gap(1), -capacity, capacity);
    add_interface_force(made.elements[k], force - made.states[k].force, Vec4::Zero(), left);
  }
  left.head<6>().setZero();  // held
  return left.cwiseAbs().maxCoeff();
}

TEST(GivenCapacities, HeapsHaveOneAnswerWhereverTheWayBegins) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap(seed);
    const GivenStep solved(made);
    ASSERT_EQ(solved.solution.status, Status::ok) << seed;
    const double largest = solved.solver.contacts().largest_force();
    // Balances hold to 1e-10 of the largest contact force; moments and strains are forces at arms of half a metre.
    EXPECT_LT(largest_residual(made, solved.solver.increment()), 1e-8 * largest) << seed;
    std::mt19937_64 random(seed);
    for (double& entry : made.guess) entry = drawn_between(random, -10, 10);
    const GivenStep from_elsewhere(made);
    ASSERT_EQ(from_elsewhere.solution.status, Status::ok) << seed;
    const Eigen::VectorXd apart = from_elsewhere.solver.increment() - solved.solver.increment();
    EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-6 * solved.solver.increment().cwiseAbs().maxCoeff()) << seed;
  }
}

// What interior passes alone leave, and how many they are: a dozen or two, with friction and without.
TEST(GivenCapacities, InteriorPassesComeToTheAnswerByThemselves) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap(seed);
    if (seed % 4 == 0)
      for (EndStrength& strength : made.strengths) strength.friction = 0;
    Costs costs;
    Iterate at(costs);
    at.matrix.begin(made.base, SolverKind::dense, 1);
    at.increment.setZero(made.rhs.size());
    const StepProblem problem = made.problem();
    at.problem = &problem;
    at.contacts.start(problem.contacts);
    InteriorPasses passes;
    ASSERT_TRUE(InteriorPasses::serve(at));
    ASSERT_TRUE(passes.begin(at)) << seed;
    ASSERT_TRUE(passes.approach(at, 1e-8)) << seed;
    EXPECT_LT(largest_residual(made, at.increment), 1e-6 * at.contacts.largest_force()) << seed;
    EXPECT_LT(costs.counters.open_close_iterations, 40) << seed;
  }
}

}  // namespace
}  // namespace dda
