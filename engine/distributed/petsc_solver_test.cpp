#include "engine/distributed/petsc_solver.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "engine/distributed/processes.h"
#include "engine/linear/pcg_solver.h"
#include "engine/linear/solver_choice.h"
#include "engine/linear/solver_test_support.h"

namespace dda {
namespace {

// As EverySolver of engine/linear: 1e-12 in the residual, times the square root of the condition number (below 1e4)
// for the energy norm, and once more for the plain one.
constexpr double tolerance = 1e-8;

void expect_solves(PetscSolver& solver, const RandomSystem& system) {
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  const Eigen::VectorXd expected = oracle(system);
  for (Eigen::VectorXd x : {Eigen::VectorXd(Eigen::VectorXd::Zero(system.rhs.size())), Eigen::VectorXd(2 * expected)}) {
    ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
    EXPECT_LE((x - expected).norm(), tolerance * expected.norm());
  }
}

TEST(PetscSolver, AgreesWithDenseOnRandomGraphs) {
  for (const int fill : {IncompleteCholesky::diagonal, 0, 1})
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const int blocks = static_cast<int>(seed) * 3 - 2;  // from one, which is fewer than there are processes
      const RandomSystem system = random_system(blocks, random_couplings(blocks, 2 * blocks, seed), seed);
      PetscSolver solver({.fill_level = fill});
      solver.analyze(system.matrix);
      expect_solves(solver, system);
    }
}

TEST(PetscSolver, AgreesWithDenseOnChainAndGrid) {
  for (const auto& [columns, rows] : {std::pair{40, 1}, std::pair{9, 8}}) {
    const RandomSystem system = random_system(columns * rows, grid_couplings(columns, rows), 5);
    PetscSolver solver({.fill_level = 1});
    solver.analyze(system.matrix);
    expect_solves(solver, system);
  }
}

TEST(PetscSolver, SolvesWithOtherValuesAndOtherPatterns) {
  PetscSolver solver({.fill_level = 1});
  for (unsigned pattern = 1; pattern <= 3; ++pattern) {
    const auto couplings = random_couplings(12, 25, pattern);
    for (unsigned values = 3; values <= 4; ++values) {
      const RandomSystem system = random_system(12, couplings, values);
      if (values == 3) solver.analyze(system.matrix);
      expect_solves(solver, system);
    }
  }
}

// As two stages of a run, or two runs that are compared, have them.
TEST(PetscSolver, LivesBesideOthers) {
  const RandomSystem system = random_system(20, grid_couplings(5, 4), 7);
  const RandomSystem other = random_system(9, grid_couplings(9, 1), 8);
  PetscSolver one({.fill_level = 1});
  one.analyze(system.matrix);
  ASSERT_EQ(one.factorize(system.matrix), Status::ok);
  {
    PetscSolver two;
    const PetscSolver never_used;
    two.analyze(other.matrix);
    expect_solves(two, other);
  }
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
  ASSERT_EQ(one.solve(system.rhs, x), Status::ok);
  EXPECT_LE((x - oracle(system)).norm(), tolerance * x.norm());
}

// One process has the preconditioner of our own iteration, and so its iterations; more drop what couples their rows.
TEST(PetscSolver, TakesAsManyIterationsAsOurOwnInOneProcess) {
  const RandomSystem system = random_system(72, grid_couplings(9, 8), 5);
  PetscSolver solver({.fill_level = 1});
  PcgSolver own({.fill_level = 1});
  for (LinearSolver* each : {static_cast<LinearSolver*>(&solver), static_cast<LinearSolver*>(&own)}) {
    each->analyze(system.matrix);
    ASSERT_EQ(each->factorize(system.matrix), Status::ok);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
    ASSERT_EQ(each->solve(system.rhs, x), Status::ok);
  }
  if (Ranks::count() == 1) {
    EXPECT_EQ(solver.counts().iterations, own.counts().iterations);
  } else {
    EXPECT_GE(solver.counts().iterations, own.counts().iterations);
    EXPECT_LE(solver.counts().iterations, 4 * own.counts().iterations);
  }
}

TEST(PetscSolver, PreconditionsSymmetrically) {
  const RandomSystem system = random_system(30, grid_couplings(6, 5), 3);
  PetscSolver solver({.fill_level = 1});
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  const Eigen::VectorXd one = Eigen::VectorXd::Random(180);
  const Eigen::VectorXd other = Eigen::VectorXd::Random(180);
  Eigen::VectorXd z(180), w(180);
  const double product = solver.precondition(one, z);
  EXPECT_NEAR(product, one.dot(z), 1e-12 * one.norm() * z.norm());
  solver.precondition(other, w);
  EXPECT_NEAR(other.dot(z), one.dot(w), 1e-5 * z.norm() * other.norm());  // the factor has single precision
  EXPECT_GT(one.dot(z), 0);
}

TEST(PetscSolver, TakesParts) {
  const RandomSystem system = random_system(6, grid_couplings(6, 1), 1);
  PetscSolver solver;
  solver.analyze(system.matrix);
  expect_takes_a_part(solver, system);
  expect_solves(solver, system);
}

// Whichever process has it.
TEST(PetscSolver, ReportsASingularBlockAndRecovers) {
  RandomSystem system = random_system(4, {{0, 1}, {2, 3}}, 1);
  PetscSolver solver({.fill_level = 1});
  solver.analyze(system.matrix);
  for (int block = 0; block < 4; ++block) {
    const Mat6 sound = system.matrix.diagonal(block);
    system.matrix.diagonal(block).setZero();
    system.matrix.diagonal(block).topLeftCorner<3, 3>().setIdentity();
    EXPECT_EQ(solver.factorize(system.matrix), Status::singular);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(24);
    EXPECT_THROW(static_cast<void>(solver.solve(system.rhs, x)), std::logic_error);
    system.matrix.diagonal(block)(3, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(solver.factorize(system.matrix), Status::singular);
    system.matrix.diagonal(block) = sound;
    expect_solves(solver, system);
  }
}

TEST(PetscSolver, NeedsNoIterationFromTheSolutionOrForNoLoad) {
  const RandomSystem system = random_system(20, grid_couplings(20, 1), 1);
  PetscSolver solver({.relative_residual = 1e-8});
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = oracle(system);
  ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
  ASSERT_EQ(solver.solve(Eigen::VectorXd::Zero(120), x), Status::ok);
  EXPECT_EQ(solver.counts().iterations, 0);
  EXPECT_TRUE(x.isZero(0));
}

TEST(PetscSolver, ReportsFailure) {
  RandomSystem system = random_system(20, grid_couplings(20, 1), 1);
  PetscSolver solver({.max_iterations = 3});
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(120);
  EXPECT_EQ(solver.solve(system.rhs, x), Status::not_converged);
  EXPECT_EQ(solver.counts().iterations, 3);
  for (const Eigen::Index at : {5, 115}) {
    Eigen::VectorXd rhs = system.rhs;
    rhs(at) = std::numeric_limits<double>::infinity();
    x.setZero();
    EXPECT_EQ(solver.solve(rhs, x), Status::not_finite);
  }
}

TEST(PetscSolver, DoesNotTrustWhatRoundOffHasSpoilt) {
  const RandomSystem system = spoilt_by_round_off();
  PetscSolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(180);
  EXPECT_NE(solver.solve(system.rhs, x), Status::ok);
}

TEST(PetscSolver, ReportsAnIndefiniteMatrix) {
  const BlockMatrix matrix = indefinite_pair();
  Eigen::VectorXd down = Eigen::VectorXd::Ones(12);
  down.tail<6>() *= -1;
  const Eigen::VectorXd both = Eigen::VectorXd::LinSpaced(12, 1, -2);
  for (const Eigen::VectorXd& rhs : {down, both})
    for (const double guess : {0.0, 0.5}) {
      PetscSolver solver;
      solver.analyze(matrix);
      ASSERT_EQ(solver.factorize(matrix), Status::ok);
      Eigen::VectorXd x = Eigen::VectorXd::Constant(12, guess);
      EXPECT_EQ(solver.solve(rhs, x), Status::singular);
    }
}

TEST(PetscSolver, IsWhatTheEngineGetsForItsName) {
  const auto solver = make_solver(SolverKind::petsc, 1, MatrixUse::stays);
  EXPECT_NE(dynamic_cast<PetscSolver*>(solver.get()), nullptr);
  EXPECT_FALSE(solver->needs_matrix());
  EXPECT_TRUE(make_solver(SolverKind::petsc)->needs_matrix());
}

TEST(PetscSolver, SolvesNothingForNoBlocks) {
  const BlockMatrix matrix(0, {});
  PetscSolver solver;
  solver.analyze(matrix);
  EXPECT_EQ(solver.factorize(matrix), Status::ok);
  Eigen::VectorXd x(0);
  EXPECT_EQ(solver.solve(Eigen::VectorXd(0), x), Status::ok);
}

}  // namespace
}  // namespace dda

// The first process runs the tests, the others what they ask for.
int main(int argc, char** argv) {
  const dda::Processes processes;
  if (!dda::Processes::is_first()) return dda::Processes::follow();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
