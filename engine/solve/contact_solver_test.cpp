// The open-close iteration on problems written by hand: answers in closed form, and the laws as an oracle where there
// are none.
#include "engine/solve/contact_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/contact/contact_set.h"
#include "engine/core/allocation_counter.h"
#include "engine/solve/solve_problems.h"

namespace dda {
namespace {

constexpr double inertia = 100;
constexpr double kn = HandMadeProblem::normal_spring;
constexpr double ks = HandMadeProblem::shear_spring;

// Balances hold to 1e-10 of the largest contact force, displacements here are about a hundredth of forces.
constexpr double tolerance = 1e-10;

struct Solved {
  explicit Solved(const HandMadeProblem& made, SolverKind kind = SolverKind::dense) : solver(costs) {
    solver.begin(made.base, kind, 1);
    solution = solver.solve(made.problem());
  }
  [[nodiscard]] Vec2 moved(int block) const { return solver.increment().segment<2>(6 * block); }

  Costs costs;
  ContactSolver solver;
  StepSolution solution;
};

// inertia u = push - contact force; the contact is closed with f = k u.
TEST(ContactSolver, ABlockThatIsPressedSticks) {
  const Solved solved(block_on_floor({10, -100}));
  ASSERT_EQ(solved.solution.status, Status::ok);
  const Vec2 expected(10 / (inertia + ks), -100 / (inertia + kn));
  EXPECT_LT(ks * expected.x(), 0.5 * kn * -expected.y());  // within friction
  EXPECT_LT((solved.moved(1) - expected).norm(), tolerance);
  EXPECT_NEAR(solved.solver.contacts()[0].force(0), kn * expected.y(), tolerance);
  EXPECT_NEAR(solved.solver.contacts()[0].force(1), -ks * expected.x(), tolerance);  // the tangent points left
}

TEST(ContactSolver, ABlockThatIsPushedBeyondFrictionSlides) {
  for (const double side : {1.0, -1.0}) {
    const Solved solved(block_on_floor({100 * side, -100}));
    ASSERT_EQ(solved.solution.status, Status::ok);
    const double up = -100 / (inertia + kn);
    const double friction = 0.5 * kn * -up;
    const Vec2 expected(side * (100 - friction) / inertia, up);
    EXPECT_LT((solved.moved(1) - expected).norm(), tolerance);
    EXPECT_NEAR(solved.solver.contacts()[0].force(1), -side * friction, tolerance);
  }
}

// What was foreseen of the gap is in the friction that the first pass expects: it is not to take another for it.
TEST(ContactSolver, ABlockThatSlidesOnTakesOnePassWhateverGapsAreForeseen) {
  for (const double foreseen : {0.0, 1e-3, -1e-3}) {
    HandMadeProblem made = block_on_floor({100, -100});
    InterfaceState& state = made.states[0];
    state.status[0] = ContactStatus::sliding;
    state.gap << -0.1, -0.5 * kn * 0.1 / ks, 0, 0;
    state.force << kn * state.gap(0), ks * state.gap(1), 0, 0;
    state.gap(0) += foreseen;
    const Solved solved(made);
    ASSERT_EQ(solved.solution.status, Status::ok);
    EXPECT_EQ(solved.solver.contacts()[0].force(1), 0.5 * solved.solver.contacts()[0].force(0));
    EXPECT_EQ(solved.costs.counters.open_close_iterations, 1) << foreseen;
  }
}

TEST(ContactSolver, ABlockThatIsLiftedOpens) {
  const Solved solved(block_on_floor({30, 50}));
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_LT((solved.moved(1) - Vec2(30, 50) / inertia).norm(), tolerance);
  EXPECT_EQ(solved.solver.contacts()[0].force, Vec4::Zero());
}

// A gap that closes on the way: springs answer to what is beyond it.
TEST(ContactSolver, AGapClosesFirst) {
  HandMadeProblem made = block_on_floor({0, -100});
  made.states[0].gap(0) = 0.1;
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_NEAR(solved.moved(1).y(), (-100 - kn * 0.1) / (inertia + kn), tolerance);
}

// Forces of the start are part of the right-hand side: where nothing changes nothing moves.
TEST(ContactSolver, ForcesOfTheStartStay) {
  HandMadeProblem made = block_on_floor({0, 0});
  made.states[0].gap << -0.2, 0.05, 0, 0;
  made.states[0].force << -0.2 * kn, 0.05 * ks, 0, 0;
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_LT(solved.moved(1).norm(), tolerance);
  EXPECT_EQ(solved.solver.contacts()[0].force, made.states[0].force);
}

// Contacts that stay as they were leave the matrix that was factored: no iteration is taken, and all digits are there.
TEST(ContactSolver, WhereNothingChangesOneSolutionWithTheFactorIsTheStep) {
  HandMadeProblem made = block_on_floor({10, -100});
  made.states[0].gap << -0.2, 0, 0, 0;
  made.states[0].force << -0.2 * kn, 0, 0, 0;
  const Solved solved(made, SolverKind::cholesky);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_EQ(solved.costs.counters.open_close_iterations, 1);
  EXPECT_EQ(solved.costs.counters.solver_iterations, 0);
  EXPECT_LT((solved.moved(1) - Vec2(10 / (inertia + ks), -100 / (inertia + kn))).norm(), 1e-15);
  made.states[0].gap(0) = made.states[0].force(0) = 0;  // closes in the step: the factor is one without it
  const Solved closing(made, SolverKind::cholesky);
  ASSERT_EQ(closing.solution.status, Status::ok);
  EXPECT_GT(closing.costs.counters.solver_iterations, 0);
}

// What is out of balance is next to nothing beside the contact's force, and yet more than is asked for on the block.
TEST(ContactSolver, APassIsTakenWhereMoreBalanceIsAskedFor) {
  HandMadeProblem made = block_on_floor({0, -1e-11});
  made.states[0].gap << -1, 0, 0, 0;
  made.states[0].force << -kn, 0, 0, 0;
  EXPECT_EQ(Solved(made).moved(1), Vec2::Zero());
  made.asked_balance = {0, 2e-11};
  EXPECT_EQ(Solved(made).moved(1), Vec2::Zero());
  made.asked_balance = {0, 1e-12};
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_NEAR(solved.moved(1).y(), -1e-11 / (inertia + kn), 1e-6 * 1e-11 / kn);  // GMRES goes to 1e-8
}

// Two blocks in a stack, of which the upper one slides on the lower one, which sticks to the floor.
TEST(ContactSolver, OneOfTwoContactsSlides) {
  HandMadeProblem made(3, {{0, 1}, {1, 2}});
  made.hold(0, Vec6::Zero());
  made.add_contact(0, 1, Vec2::Zero(), Vec2::Zero(), 2);
  made.add_contact(1, 2, Vec2::Zero(), Vec2::Zero(), 0.25);
  made.rhs.segment<2>(12) = Vec2(150, -200);
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  // Normal: (inertia + 2 kn) u1 = kn u2, (inertia + kn) u2 - kn u1 = -200.
  const double u2 = -200 / (inertia + kn - kn * kn / (inertia + 2 * kn));
  const double u1 = kn * u2 / (inertia + 2 * kn);
  const double friction = 0.25 * kn * (u1 - u2);
  EXPECT_LT((solved.moved(2) - Vec2((150 - friction) / inertia, u2)).norm(), tolerance);
  EXPECT_LT((solved.moved(1) - Vec2(friction / (inertia + ks), u1)).norm(), tolerance);
}

// Three contacts at one place carry together what one of three times the stiffness would.
TEST(ContactSolver, RedundantContactsShareTheLoad) {
  HandMadeProblem made = block_on_floor({100, -100});
  made.add_contact(0, 1, Vec2::Zero(), Vec2::Zero(), 0.5);
  made.add_contact(0, 1, Vec2::Zero(), Vec2::Zero(), 0.5);
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  const double up = -100 / (inertia + 3 * kn);
  const double friction = 0.5 * 3 * kn * -up;
  EXPECT_LT((solved.moved(1) - Vec2((100 - friction) / inertia, up)).norm(), tolerance);
  for (std::size_t k = 1; k < 3; ++k) EXPECT_EQ(solved.solver.contacts()[k].force, solved.solver.contacts()[0].force);
}

// A floor that is lifted by given increments carries the block along.
TEST(ContactSolver, HeldBlocksPush) {
  HandMadeProblem made = block_on_floor({0, 0});
  made.held.increments[0](1) = 0.1;
  made.held.move = true;
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_EQ(solved.moved(0), Vec2(0, 0.1));
  EXPECT_NEAR(solved.moved(1).y(), kn * 0.1 / (inertia + kn), tolerance);
}

LinkElement tie(double rupture_elongation) {
  LinkElement link;
  link.block_a = 0;
  link.block_b = 1;
  link.law = {{kn, 0}, {-unlimited, -unlimited}, {unlimited, unlimited}};
  link.rupture_elongation = rupture_elongation;
  link.rows = bolt_rows({0, 1}, Vec2::Zero(), Vec2::Zero());
  return link;
}

TEST(ContactSolver, ABoltHoldsABlock) {
  HandMadeProblem made = block_on_floor({0, 50});
  made.links = {tie(1)};
  const Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_FALSE(solved.solution.something_broke());
  EXPECT_NEAR(solved.moved(1).y(), 50 / (inertia + kn), tolerance);
}

// What breaks comes back as an event; what is solved on from there is without it.
TEST(ContactSolver, ABoltThatBreaksIsAnEvent) {
  HandMadeProblem made = block_on_floor({0, 50});
  made.links = {tie(0.05)};
  Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_EQ(solved.solution.broken_links, std::vector<int>{0});
  const StepSolution& after = solved.solver.go_on(made.problem());
  ASSERT_EQ(after.status, Status::ok);
  EXPECT_FALSE(after.something_broke());
  EXPECT_NEAR(solved.moved(1).y(), 50 / inertia, tolerance);
  EXPECT_TRUE(solved.solver.bolts()[0].ruptures);
}

// The same of an end with strength: half of the tension is carried, then none.
TEST(ContactSolver, AnEndThatBreaksIsAnEvent) {
  HandMadeProblem made = block_on_floor({0, 50});
  made.states[0].broken = {false, false};
  made.strengths[0] = {.tension = 30, .cohesion = 30, .friction = 0.5};
  Solved solved(made);
  ASSERT_EQ(solved.solution.status, Status::ok);
  EXPECT_NEAR(solved.moved(1).y(), 50 / (inertia + kn), tolerance);
  EXPECT_EQ(solved.solution.broken_contacts, std::vector<int>{0});  // it carries 40
  const StepSolution& after = solved.solver.go_on(made.problem());
  ASSERT_EQ(after.status, Status::ok);
  EXPECT_FALSE(after.something_broke());
  EXPECT_NEAR(solved.moved(1).y(), 50 / inertia, tolerance);
}

// An interface that was part of the base becomes a contact in mid-iteration.
TEST(ContactSolver, ABondedInterfaceIsAdmitted) {
  HandMadeProblem made = block_on_floor({0, 50});
  made.places.clear();
  add_contact(1, made.elements[0], {Vec4(1, 1, 0, 0), 0}, true, true, made.base);
  Solved solved(made);
  EXPECT_NEAR(solved.moved(1).y(), 50 / (inertia + kn), tolerance);
  HandMadeProblem after = block_on_floor({0, 50});
  after.version = 2;
  solved.solver.admit(after.problem(), 0, {true, true});
  const StepSolution& solution = solved.solver.go_on(after.problem());
  ASSERT_EQ(solution.status, Status::ok);
  EXPECT_NEAR(solved.moved(1).y(), 50 / inertia, tolerance);
}

// A block on two corners of which one has still to come down, which takes a second pass that is not allowed.
HandMadeProblem cut_short() {
  HandMadeProblem made = block_on_floor({100, -100});
  made.max_passes = 1;
  made.add_contact(0, 1, Vec2(-0.5, 0), Vec2(-0.5, -0.5), 0.5);
  made.states[1].gap(0) = 0.01;
  return made;
}

TEST(ContactSolver, SaysWhichContactDoesNotSettle) {
  const Solved solved(cut_short());
  EXPECT_EQ(solved.solution.status, Status::not_converged);
  EXPECT_EQ(solved.solution.failure, Failure::unsettled);
  EXPECT_GE(solved.solution.restless_contact, 0);
  EXPECT_GT(solved.solution.restless_force, 0);
}

// Quick passes give up, and so do those from inside; the sure ones find the answer unless the step is rather to be
// shortened.
TEST(ContactSolver, TakesTheSurePassesOnlyWhereItMustGoToTheEnd) {
  HandMadeProblem made = cut_short();
  const Solved to_the_end(made);
  made.to_the_end = false;
  const Solved quickly(made);
  EXPECT_EQ(quickly.solution.status, Status::not_converged);
  EXPECT_EQ(quickly.solution.failure, Failure::unsettled);
  EXPECT_EQ(quickly.costs.counters.open_close_iterations, 2);
  EXPECT_EQ(to_the_end.costs.counters.open_close_iterations, 3);
}

TEST(ContactSolver, SaysWhenTheMatrixIsSingular) {
  HandMadeProblem made = block_on_floor({0, 50});
  made.base.diagonal(1).setZero();
  const Solved solved(made);
  EXPECT_EQ(solved.solution.status, Status::singular);
  EXPECT_EQ(solved.solution.failure, Failure::singular_matrix);
}

// Blocks piled up at random on a floor, each on two corners, pushed and pressed at random.
HandMadeProblem random_pile(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> of(-1, 1);
  constexpr int blocks = 6;
  std::vector<std::pair<int, int>> couplings;
  for (int i = 1; i < blocks; ++i) couplings.emplace_back(i - 1, i);
  HandMadeProblem made(blocks, couplings);
  made.hold(0, Vec6::Zero());
  for (int i = 1; i < blocks; ++i) {
    for (const double corner : {-0.5, 0.5}) {
      const std::size_t k = made.add_contact(i - 1, i, {corner, 0.5}, {corner, -0.5}, 0.3 + 0.3 * of(random));
      made.states[k].gap(0) = 0.02 * of(random);
      made.states[k].gap(1) = 0.01 * of(random);
      made.states[k].force(0) = std::min(0.0, kn * made.states[k].gap(0));
    }
    made.rhs.segment<6>(6 * i) << 60 * of(random), -40 + 60 * of(random), 20 * of(random), 0, 0, 0;
  }
  return made;
}

// The laws, and the balance with the forces that they make of the increments found.
TEST(ContactSolver, RandomPilesFulfilBalanceAndLaws) {
  int open = 0, stuck = 0, sliding = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const HandMadeProblem made = random_pile(seed);
    const Solved solved(made);
    ASSERT_EQ(solved.solution.status, Status::ok) << seed;
    const Eigen::VectorXd& d = solved.solver.increment();
    Eigen::VectorXd left(d.size());
    made.base.multiply(d, left);
    left -= made.rhs;
    double largest = 0;
    for (std::size_t k = 0; k < made.elements.size(); ++k) {
      const Vec4 gap = made.states[k].gap + gap_increment(made.elements[k], d);
      const double normal = std::min(0.0, kn * gap(0));
      const double capacity = -made.strengths[k].friction * normal;
      const double shear = std::clamp(ks * gap(1), -capacity, capacity);
      const Vec4 force(normal, shear, 0, 0);
      add_interface_force(made.elements[k], force - made.states[k].force, Vec4::Zero(), left);
      largest = std::max(largest, force.cwiseAbs().maxCoeff());
      (normal == 0 ? open : std::abs(shear) < capacity ? stuck : sliding) += 1;
    }
    made.held.clear(left);
    EXPECT_LE(left.cwiseAbs().maxCoeff(), 1e-9 * std::max(1.0, largest)) << seed;
  }
  for (const int cases : {open, stuck, sliding}) EXPECT_GT(cases, 100);
}

// The sure passes alone, which the solver takes where the quick ones do not end, lead to the same answer.
TEST(ContactSolver, SurePassesFindWhatQuickOnesFind) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const HandMadeProblem made = random_pile(seed);
    const StepProblem problem = made.problem();
    Costs costs;
    Iterate at(costs);
    at.problem = &problem;
    at.matrix.begin(made.base, SolverKind::dense, 1);
    at.contacts.start(problem.contacts);
    at.bolts.start(problem.bolts);
    at.increment = Eigen::VectorXd::Zero(made.rhs.size());
    ConvexPasses convex;
    convex.start(made.guess);
    ASSERT_EQ(convex.settle(at, made.max_passes), Status::ok) << seed;
    const Solved quick(made);
    EXPECT_LT((at.increment - quick.solver.increment()).norm(), 1e-9) << seed;
  }
}

TEST(ContactSolver, FindsTheSameWithEverySolver) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const HandMadeProblem made = random_pile(seed);
    const Solved dense(made), cholesky(made, SolverKind::cholesky), pcg(made, SolverKind::pcg);
    for (const Solved* other : {&cholesky, &pcg})
      EXPECT_LT((other->solver.increment() - dense.solver.increment()).norm(), 1e-9) << seed;
  }
}

TEST(ContactSolver, AllocatesNothingWhenWarm) {
  const HandMadeProblem made = random_pile(1);
  Solved solved(made, SolverKind::cholesky);
  (void)solved.solver.solve(made.problem());
  const long before = allocations_so_far();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(solved.solver.solve(made.problem()).status, Status::ok);
  EXPECT_EQ(allocations_so_far(), before);
}

// A solver that has solved other problems before finds the same to the last bit.
TEST(ContactSolver, RemembersNothingOfOtherProblems) {
  const HandMadeProblem made = random_pile(3);
  HandMadeProblem other = random_pile(4);
  other.version = 2;
  const Solved fresh(made);
  Solved used(other);
  EXPECT_EQ(used.solver.solve(made.problem()).status, Status::ok);
  EXPECT_EQ(used.solver.increment(), fresh.solver.increment());
}

}  // namespace
}  // namespace dda
