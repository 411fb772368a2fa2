// For tests: steps whose friction is given by their start, and what is asked of their answers.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "engine/contact/contact_set.h"
#include "engine/solve/interior_passes.h"
#include "engine/solve/solve_problems.h"

namespace dda {

struct SolvedStep {
  explicit SolvedStep(const HandMadeProblem& made) : solver(costs) {
    solver.begin(made.base, SolverKind::dense, 1);
    solution = solver.solve(made.problem());
  }

  Costs costs;
  ContactSolver solver;
  StepSolution solution;
};

// What is left of the balance at given increments where contact k answers force_at(k, gap) to its gap.
template <typename ForceAt>
double largest_residual(const HandMadeProblem& made, const Eigen::VectorXd& d, const ForceAt& force_at) {
  Eigen::VectorXd left(d.size());
  made.base.multiply(d, left);
  left -= made.rhs;
  for (std::size_t k = 0; k < made.elements.size(); ++k) {
    const InterfaceElement& element = made.elements[k];
    const Vec4 force = force_at(k, Vec4(made.states[k].gap + gap_increment(element, d)));
    add_interface_force(element, force - made.states[k].force, Vec4::Zero(), left);
  }
  left.head<6>().setZero();  // held
  return left.cwiseAbs().maxCoeff();
}

// Whether the problem has one answer, wherever the way to it begins: solved from where it stands and from a guess by
// lot. Balances hold to 1e-10 of the largest contact force; moments and strains are forces at arms of half a metre.
template <typename ForceAt>
void expect_one_answer(HandMadeProblem made, unsigned seed, const ForceAt& force_at) {
  const SolvedStep solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok) << seed;
  const double largest = solved.solver.contacts().largest_force();
  EXPECT_LT(largest_residual(made, solved.solver.increment(), force_at), 1e-8 * largest) << seed;
  std::mt19937_64 random(seed);
  for (double& entry : made.guess) entry = drawn_between(random, -10, 10);
  const SolvedStep from_elsewhere(made);
  ASSERT_EQ(from_elsewhere.solution.status, Status::ok) << seed;
  const Eigen::VectorXd apart = from_elsewhere.solver.increment() - solved.solver.increment();
  EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-6 * solved.solver.increment().cwiseAbs().maxCoeff()) << seed;
}

// A problem that interior passes alone have led to its answer.
struct FromInside {
  explicit FromInside(const HandMadeProblem& made) : problem(made.problem()), at(costs) {
    at.matrix.begin(made.base, SolverKind::dense, 1);
    at.increment.setZero(made.rhs.size());
    at.problem = &problem;
    at.contacts.start(problem.contacts);
    InteriorPasses passes;
    arrived = InteriorPasses::serve(at) && passes.begin(at) && passes.approach(at, 1e-8);
  }

  Costs costs;
  StepProblem problem;
  Iterate at;
  bool arrived = false;
};

}  // namespace dda
