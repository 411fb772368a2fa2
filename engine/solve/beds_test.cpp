// Steps whose blocks meet along stretches of the projected law: heaps drawn by lot, some of whose stretches gape.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/contact/contact_set.h"
#include "engine/contact/projected_law.h"
#include "engine/solve/contact_solver.h"
#include "engine/solve/interior_passes.h"
#include "engine/solve/solve_problems.h"

namespace dda {
namespace {

constexpr double normal_spring = HandMadeProblem::normal_spring;
constexpr double shear_spring = HandMadeProblem::shear_spring;

struct SolvedStep {
  explicit SolvedStep(const HandMadeProblem& made) : solver(costs) {
    solver.begin(made.base, SolverKind::dense, 1);
    solution = solver.solve(made.problem());
  }

  Costs costs;
  ContactSolver solver;
  StepSolution solution;
};

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

// The heap with stretches in place of half of its corners, some of which gape when the step begins.
HandMadeProblem heap_of_stretches(unsigned seed) {
  HandMadeProblem made = heap(seed);
  std::mt19937_64 random(1000 + seed);
  for (std::size_t k = 0; k < made.elements.size(); k += 2) {
    InterfaceElement& element = made.elements[k];
    InterfaceState& state = made.states[k];
    lay_on_bed(drawn_between(random, 0.2, 1), drawn_between(random, 0.3, 0.57), drawn_between(random, 0.1, 1), element);
    state.gap(2) = drawn_between(random, -0.2, 0.2);
    const BedAnswer bed = press_bed(bed_of(element), {state.gap(0), state.gap(2)});
    state.force << bed.force(0), 0, bed.force(1), 0;
  }
  return made;
}

// What is left of the balance at given increments, friction being that of the start.
double largest_residual_on_beds(const HandMadeProblem& made, const Eigen::VectorXd& d) {
  Eigen::VectorXd left(d.size());
  made.base.multiply(d, left);
  left -= made.rhs;
  for (std::size_t k = 0; k < made.elements.size(); ++k) {
    const InterfaceElement& element = made.elements[k];
    const InterfaceState& start = made.states[k];
    const Vec4 gap = start.gap + gap_increment(element, d);
    Vec4 force = Vec4::Zero();
    const bool on_bed = press_together(element, start.broken);
    const BedAnswer bed = on_bed ? press_bed(bed_of(element), {gap(0), gap(2)}) : BedAnswer();
    for (int end = 0; end < ends_of(element); ++end) {
      const double capacity = made.strengths[k].capacity(pressing_force(element, start.force, end), false);
      force(2 * end) = on_bed ? bed.force(end) : normal_spring * std::min(0.0, gap(2 * end));
      force(2 * end + 1) = std::clamp(shear_spring * gap(2 * end + 1), -capacity, capacity);
    }
    add_interface_force(element, force - start.force, Vec4::Zero(), left);
  }
  left.head<6>().setZero();  // held
  return left.cwiseAbs().maxCoeff();
}

TEST(StretchesOnBeds, InteriorPassesLeadToTheAnswerOfGivenFriction) {
  int gape = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap_of_stretches(seed);
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
    EXPECT_LT(largest_residual_on_beds(made, at.increment), 1e-6 * at.contacts.largest_force()) << seed;
    EXPECT_LT(costs.counters.open_close_iterations, 60) << seed;
    for (std::size_t k = 0; k < made.elements.size(); k += 2) {
      const InterfaceTrial& trial = at.contacts[k];
      const OpenEnds open = open_ends(made.elements[k].lever, {trial.gap(0), trial.gap(2)});
      if (open.first != open.second) ++gape;
    }
  }
  EXPECT_GT(gape, 200);  // of some 4,200
}

TEST(StretchesOnBeds, HaveOneAnswerUnderGivenFriction) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    HandMadeProblem made = heap_of_stretches(seed);
    const SolvedStep solved(made);
    ASSERT_EQ(solved.solution.status, Status::ok) << seed;
    const double largest = solved.solver.contacts().largest_force();
    EXPECT_LT(largest_residual_on_beds(made, solved.solver.increment()), 1e-8 * largest) << seed;
    std::mt19937_64 random(seed);
    for (double& entry : made.guess) entry = drawn_between(random, -10, 10);
    const SolvedStep from_elsewhere(made);
    ASSERT_EQ(from_elsewhere.solution.status, Status::ok) << seed;
    const Eigen::VectorXd apart = from_elsewhere.solver.increment() - solved.solver.increment();
    EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-6 * solved.solver.increment().cwiseAbs().maxCoeff()) << seed;
  }
}

}  // namespace
}  // namespace dda
