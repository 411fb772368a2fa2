#include "engine/linear/solver.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "engine/core/allocation_counter.h"
#include "engine/linear/cholesky_solver.h"
#include "engine/linear/library_function.h"
#include "engine/linear/pcg_solver.h"
#include "engine/linear/solver_choice.h"
#include "engine/linear/solver_test_support.h"

namespace dda {
namespace {

class EverySolver : public testing::TestWithParam<SolverKind> {
 protected:
  // PCG stops at a residual of 1e-12; the error in x is at most the square root of the condition number (below 1e4 in
  // these systems) times that, relative in the energy norm, and once more to get to the plain norm.
  static double tolerance(const RandomSystem& system) {
    return GetParam() == SolverKind::pcg ? 1e-8 : 10 * system.tolerance();
  }
  void expect_solves(const RandomSystem& system) {
    ASSERT_EQ(solver_->factorize(system.matrix), Status::ok);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
    ASSERT_EQ(solver_->solve(system.rhs, x), Status::ok);
    const Eigen::VectorXd expected = oracle(system);
    EXPECT_LE((x - expected).norm(), tolerance(system) * expected.norm());
  }

  std::unique_ptr<LinearSolver> solver_ = make_solver(GetParam());
};

std::string kind_name(const testing::TestParamInfo<SolverKind>& parameter) {
  return std::string(to_string(parameter.param));
}

INSTANTIATE_TEST_SUITE_P(Linear, EverySolver, testing::Values(SolverKind::cholesky, SolverKind::pcg, SolverKind::dense),
                         kind_name);

TEST_P(EverySolver, AgreesWithDenseOnRandomGraphs) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const int blocks = 1 + static_cast<int>(seed) * 3;
    const RandomSystem system = random_system(blocks, random_couplings(blocks, 2 * blocks, seed), seed);
    solver_->analyze(system.matrix);
    expect_solves(system);
  }
}

TEST_P(EverySolver, AgreesWithDenseOnChainAndGrid) {
  for (const auto& [columns, rows] : {std::pair{40, 1}, std::pair{9, 8}}) {
    const RandomSystem system = random_system(columns * rows, grid_couplings(columns, rows), 5);
    solver_->analyze(system.matrix);
    expect_solves(system);
  }
}

TEST_P(EverySolver, SolvesWithNewValuesOnTheSamePattern) {
  const auto couplings = random_couplings(12, 25, 2);
  const RandomSystem first = random_system(12, couplings, 3);
  const RandomSystem second = random_system(12, couplings, 4);
  solver_->analyze(first.matrix);
  expect_solves(first);
  expect_solves(second);
  expect_solves(first);
}

TEST_P(EverySolver, CountsWhatWasAskedOfIt) {
  const RandomSystem system = random_system(5, grid_couplings(5, 1), 1);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(30);
  solver_->analyze(system.matrix);
  ASSERT_EQ(solver_->factorize(system.matrix), Status::ok);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(solver_->solve(system.rhs, x), Status::ok);
  EXPECT_EQ(solver_->counts().analyses, 1);
  EXPECT_EQ(solver_->counts().factorizations, 1);
  EXPECT_EQ(solver_->counts().solves, 3);
  EXPECT_EQ(solver_->counts().iterations > 0, GetParam() == SolverKind::pcg);
}

TEST_P(EverySolver, RefusesCallsOutOfOrder) {
  const RandomSystem system = random_system(5, grid_couplings(5, 1), 1);
  const RandomSystem other = random_system(5, grid_couplings(4, 1), 1);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(30);
  Eigen::VectorXd too_short = Eigen::VectorXd::Zero(24);
  EXPECT_THROW(static_cast<void>(solver_->factorize(system.matrix)), std::logic_error);
  solver_->analyze(system.matrix);
  EXPECT_THROW(static_cast<void>(solver_->solve(system.rhs, x)), std::logic_error);
  EXPECT_THROW(static_cast<void>(solver_->factorize(other.matrix)), std::logic_error);
  ASSERT_EQ(solver_->factorize(system.matrix), Status::ok);
  EXPECT_THROW(static_cast<void>(solver_->solve(system.rhs, too_short)), std::logic_error);
  EXPECT_THROW(static_cast<void>(solver_->solve(x, x)), std::logic_error);
}

TEST_P(EverySolver, TakesPartsOrSaysThatItDoesNot) {
  const RandomSystem system = random_system(6, grid_couplings(6, 1), 1);
  solver_->analyze(system.matrix);
  if (!solver_->takes_parts()) {
    BlockPart part;
    part.clear(6);
    part.add(2);
    EXPECT_THROW(static_cast<void>(solver_->factorize(system.matrix, part)), std::logic_error);
    return;
  }
  expect_takes_a_part(*solver_, system);
  expect_solves(system);  // with the whole factored again
}

// Block 2 of the chain has lost its inertia and its springs hold three of its six unknowns only.
TEST_P(EverySolver, ReportsASingularBlockAndRecovers) {
  RandomSystem system = random_system(4, {{0, 1}, {2, 3}}, 1);
  solver_->analyze(system.matrix);
  const Mat6 sound = system.matrix.diagonal(2);
  system.matrix.diagonal(2).setZero();
  system.matrix.diagonal(2).topLeftCorner<3, 3>().setIdentity();
  EXPECT_EQ(solver_->factorize(system.matrix), Status::singular);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(24);
  EXPECT_THROW(static_cast<void>(solver_->solve(system.rhs, x)), std::logic_error);
  system.matrix.diagonal(2) = sound;
  expect_solves(system);
}

TEST_P(EverySolver, ReportsNotANumber) {
  RandomSystem system = random_system(4, grid_couplings(4, 1), 1);
  system.matrix.diagonal(1)(3, 3) = std::numeric_limits<double>::quiet_NaN();
  solver_->analyze(system.matrix);
  EXPECT_EQ(solver_->factorize(system.matrix), Status::singular);
}

TEST_P(EverySolver, SolvesNothingForNoBlocks) {
  const BlockMatrix matrix(0, {});
  const Eigen::VectorXd rhs(0);
  Eigen::VectorXd x(0);
  solver_->analyze(matrix);
  ASSERT_EQ(solver_->factorize(matrix), Status::ok);
  EXPECT_EQ(solver_->solve(rhs, x), Status::ok);
}

// Blocks that only springs hold together: each diagonal block is positive definite, the whole is not. By round-off the
// last pivots come out positive about as often as negative, so many seeds.
TEST(CholeskySolver, ReportsAFreeBody) {
  for (const auto& [columns, rows] : {std::pair{2, 1}, std::pair{40, 1}, std::pair{12, 12}}) {
    const auto couplings = grid_couplings(columns, rows);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Mat6 spring = random_system(1, {}, seed).rhs.asDiagonal().toDenseMatrix().cwiseAbs() + Mat6::Constant(0.01);
      BlockMatrix matrix(columns * rows, couplings);
      for (const auto& [i, j] : couplings) {
        matrix.add_coupling(i, i, spring);
        matrix.add_coupling(j, j, spring);
        matrix.add_coupling(i, j, -spring);
      }
      CholeskySolver solver;
      solver.analyze(matrix);
      EXPECT_EQ(solver.factorize(matrix), Status::singular) << columns << " x " << rows << ", seed " << seed;
    }
  }
}

// Or round-off, and with it rock that slides or breaks, would be another on each processor.
TEST(CholeskySolver, HasTheSameKernelsOnAllProcessorsOfItsKind) {
  static_cast<void>(make_solver(SolverKind::cholesky));
  auto* name = library_function<const char*()>("openblas_get_corename");
  if (name == nullptr || library_function<void()>("gotoblas_dynamic_init") == nullptr)
    GTEST_SKIP() << "no OpenBLAS that chooses its kernels";
  const char* asked = std::getenv("OPENBLAS_CORETYPE");
  if (asked == nullptr && !__builtin_cpu_supports("avx2")) GTEST_SKIP() << "a processor without AVX2";
  EXPECT_STREQ(name(), asked != nullptr ? asked : "Haswell");
}

TEST(CholeskySolver, HasNoFillOnAChain) {
  const RandomSystem system = random_system(50, grid_couplings(50, 1), 1);
  CholeskySolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  EXPECT_EQ(solver.factor_facts().nonzeros, 50 * 21 + 49 * 36);
  EXPECT_FALSE(solver.factor_facts().supernodal);
}

// Large enough for the supernodal factor of the CHOLMOD build. Row by row, the factor of a grid of 20 x 20 is a band of
// 20 blocks and 36 * 400 * 20 numbers; minimum degree must do clearly better than that.
TEST(CholeskySolver, FactorsAGridWithLittleFill) {
  const RandomSystem system = random_system(400, grid_couplings(20, 20), 2);
  CholeskySolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x(2400);
  ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
  const Eigen::VectorXd residual = system.dense * x - system.rhs;
  EXPECT_LE(residual.norm(), system.tolerance() * system.rhs.norm());
  EXPECT_LT(solver.factor_facts().nonzeros, 0.6 * 36 * 400 * 20);
#ifdef DDA_WITH_CHOLMOD
  EXPECT_TRUE(solver.factor_facts().supernodal);
#endif
}

// Springs a million times stiffer than the inertia: the residual stays at round-off (that of the factorization,
// measured against |A| |x|) although the solution loses digits.
TEST(CholeskySolver, IsBackwardStableForStiffSprings) {
  RandomSystem system = random_system(60, grid_couplings(60, 1), 9);
  for (int i = 0; i < 60; ++i) system.matrix.diagonal(i) -= (1 - 1e-6) * Mat6::Identity();
  system.dense -= (1 - 1e-6) * Eigen::MatrixXd::Identity(360, 360);
  CholeskySolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x(360);
  ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
  const double residual = (system.dense * x - system.rhs).norm();
  EXPECT_LE(residual, 360 * 2.3e-16 * system.dense.norm() * x.norm());
}

TEST(PcgSolver, NeedsNoIterationFromTheSolutionOrForNoLoad) {
  const RandomSystem system = random_system(20, grid_couplings(20, 1), 1);
  PcgSolver solver({1e-8, 1000});
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = oracle(system);
  ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
  EXPECT_EQ(solver.counts().iterations, 0);
  ASSERT_EQ(solver.solve(Eigen::VectorXd::Zero(120), x), Status::ok);
  EXPECT_EQ(solver.counts().iterations, 0);
  EXPECT_TRUE(x.isZero(0));
}

// Inverses of seven digits take two iterations to twelve.
TEST(PcgSolver, SolvesUncoupledBlocksInTwoIterations) {
  const RandomSystem system = random_system(7, {}, 1);
  PcgSolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(42);
  ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
  EXPECT_EQ(solver.counts().iterations, 2);
}

// In exact arithmetic the iteration ends after as many steps as there are distinct eigenvalues; here they are 1 +- 0.3
// and 1 +- 0.6, and the preconditioner's round-off of 6e-8 does not matter yet. A search direction that is not
// conjugate takes longer.
TEST(PcgSolver, EndsAfterAsManyIterationsAsDistinctEigenvalues) {
  BlockMatrix matrix(2, {{0, 1}});
  for (int i = 0; i < 2; ++i) matrix.diagonal(i).setIdentity();
  Vec6 coupling;
  coupling << 0.3, 0.3, 0.3, 0.6, 0.6, 0.6;
  matrix.add_coupling(1, 0, coupling.asDiagonal().toDenseMatrix());
  PcgSolver solver({1e-6, 20});
  solver.analyze(matrix);
  ASSERT_EQ(solver.factorize(matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(12);
  ASSERT_EQ(solver.solve(Eigen::VectorXd::LinSpaced(12, 1, 3), x), Status::ok);
  EXPECT_EQ(solver.counts().iterations, 4);
}

// Laid out for products, with equal diagonal blocks, whose inverses are kept once, and with different ones.
TEST(PcgSolver, SolvesAsWellWithAMatrixThatStays) {
  const auto grid = grid_couplings(10, 6);
  RandomSystem equal{BlockMatrix(60, grid), Eigen::MatrixXd::Identity(360, 360), Eigen::VectorXd::Random(360)};
  for (int i = 0; i < 60; ++i) equal.matrix.diagonal(i).setIdentity();
  for (const auto& [i, j] : grid) {
    equal.matrix.add_coupling(i, j, -2 * Mat6::Identity());
    equal.dense.block<6, 6>(6 * i, 6 * j).diagonal().array() -= 2;
    equal.dense.block<6, 6>(6 * j, 6 * i).diagonal().array() -= 2;
    for (const int k : {i, j}) {
      equal.matrix.diagonal(k) += 2 * Mat6::Identity();
      equal.dense.block<6, 6>(6 * k, 6 * k) += 2 * Mat6::Identity();
    }
  }
  for (const RandomSystem& system : {equal, random_system(40, random_couplings(40, 60, 4), 4)}) {
    PcgSolver solver({.matrix_stays = true});
    solver.analyze(system.matrix);
    ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
    for (int repeat = 0; repeat < 2; ++repeat) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
      ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
      EXPECT_LE((x - oracle(system)).norm(), 1e-8 * oracle(system).norm());  // as EverySolver
    }
  }
}

TEST(PcgSolver, DoesNotTrustWhatRoundOffHasSpoilt) {
  const RandomSystem system = spoilt_by_round_off();
  PcgSolver solver;
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd easy = Eigen::VectorXd::Zero(system.rhs.size());
  EXPECT_EQ(solver.solve(Eigen::VectorXd::Zero(system.rhs.size()), easy), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
  EXPECT_NE(solver.solve(system.rhs, x), Status::ok);  // more iterations than were checked
}

// As where rock has moved far in the step before and is at rest in this one.
TEST(PcgSolver, ForgetsAGuessThatIsFarTooLarge) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomSystem system = random_system(20, grid_couplings(20, 1), seed);
    PcgSolver solver;
    solver.analyze(system.matrix);
    ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
    const Eigen::VectorXd solution = oracle(system);
    Eigen::VectorXd x = 1e12 * solution.reverse();
    ASSERT_EQ(solver.solve(system.rhs, x), Status::ok) << seed;
    EXPECT_LE((x - solution).norm(), 1e-8 * solution.norm()) << seed;  // as EverySolver
  }
}

TEST(PcgSolver, ReportsFailure) {
  RandomSystem system = random_system(20, grid_couplings(20, 1), 1);
  PcgSolver solver({1e-12, 3});
  solver.analyze(system.matrix);
  ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(120);
  EXPECT_EQ(solver.solve(system.rhs, x), Status::not_converged);
  EXPECT_EQ(solver.counts().iterations, 3);
  system.rhs(5) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(solver.solve(system.rhs, x), Status::not_finite);
}

TEST(PcgSolver, ReportsAnIndefiniteMatrix) {
  const BlockMatrix matrix = indefinite_pair();
  Eigen::VectorXd rhs = Eigen::VectorXd::Ones(12);
  rhs.tail<6>() *= -1;
  PcgSolver solver;
  solver.analyze(matrix);
  ASSERT_EQ(solver.factorize(matrix), Status::ok);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(12);
  EXPECT_EQ(solver.solve(rhs, x), Status::singular);
}

long allocations_of_warm_solve(LinearSolver& solver, const RandomSystem& system, bool with_factorize) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
  solver.analyze(system.matrix);
  EXPECT_EQ(solver.factorize(system.matrix), Status::ok);
  EXPECT_EQ(solver.solve(system.rhs, x), Status::ok);
  const long before = allocations_so_far();
  Status status = with_factorize ? solver.factorize(system.matrix) : Status::ok;
  if (status == Status::ok) status = solver.solve(system.rhs, x);
  const long after = allocations_so_far();
  EXPECT_EQ(status, Status::ok);
  return after - before;
}

TEST(Allocations, NoneInAWarmSolve) {
  for (const auto& [columns, rows] : {std::pair{60, 1}, std::pair{20, 20}}) {
    const RandomSystem system = random_system(columns * rows, grid_couplings(columns, rows), 1);
    CholeskySolver cholesky;
    PcgSolver pcg;
    EXPECT_EQ(allocations_of_warm_solve(cholesky, system, false), 0);
    EXPECT_EQ(allocations_of_warm_solve(pcg, system, true), 0);
  }
}

#ifdef DDA_WITH_CHOLMOD
TEST(Allocations, NoneInAWarmSimplicialFactorization) {
  const RandomSystem system = random_system(60, grid_couplings(60, 1), 1);
  CholeskySolver cholesky;
  EXPECT_EQ(allocations_of_warm_solve(cholesky, system, true), 0);
}
#endif

}  // namespace
}  // namespace dda
