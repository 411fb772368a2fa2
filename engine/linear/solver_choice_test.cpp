#include "engine/linear/solver_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace dda {
namespace {

// The scenes of the table in the README, well away from where the costs cross.
TEST(ChooseSolver, ReusesAFactorOfAConstantMatrix) {
  for (const double chi : {0.02, 0.2, 2.0, 20.0}) {
    EXPECT_EQ(choose_solver({200, 199, chi, false}), SolverKind::cholesky);
    EXPECT_EQ(choose_solver({2500, 4900, chi, false}), SolverKind::cholesky);
  }
}

TEST(ChooseSolver, IteratesWhereACompleteFactorLeavesTheCacheUnlessTheStepIsLong) {
  for (const double chi : {0.01, 0.3, 3.0}) {
    EXPECT_EQ(choose_solver({10000, 19800, chi, false}), SolverKind::pcg);
    EXPECT_EQ(choose_solver({40000, 79600, chi, false}), SolverKind::pcg);
  }
  for (const double chi : {32.0, 200.0}) EXPECT_EQ(choose_solver({10000, 19800, chi, false}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({10000, 9999, 0.3, false}), SolverKind::cholesky);
}

TEST(ChooseSolver, IteratesWhereTheMatrixChangesEveryStepUnlessItIsStiff) {
  EXPECT_EQ(choose_solver({200, 199, 0.02, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({200, 199, 200.0, true}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({2500, 4900, 2.0, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({2500, 4900, 200.0, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({2500, 4900, 2e4, true}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({10000, 19800, 2.0, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({10000, 19800, 200.0, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({10000, 19800, 1e5, true}), SolverKind::cholesky);
}

TEST(ChooseSolver, FactorsStaticSteps) {
  for (const double chi : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(choose_solver({10000, 19800, chi, true}), SolverKind::cholesky);
  }
}

}  // namespace
}  // namespace dda
