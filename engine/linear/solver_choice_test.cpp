#include "engine/linear/solver_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace dda {
namespace {

StiffnessNumbers alike(double chi) { return {.largest = chi, .of_most = chi}; }

// The scenes of the table in the README, well away from where the costs cross.
TEST(ChooseSolver, ReusesAFactorOfAConstantMatrix) {
  for (const double chi : {0.02, 0.2, 2.0, 20.0}) {
    EXPECT_EQ(choose_solver({200, 199, alike(chi), false}), SolverKind::cholesky);
    EXPECT_EQ(choose_solver({2500, 4900, alike(chi), false}), SolverKind::cholesky);
  }
}

TEST(ChooseSolver, IteratesWhereACompleteFactorLeavesTheCacheUnlessTheStepIsLong) {
  for (const double chi : {0.01, 0.3, 3.0}) {
    EXPECT_EQ(choose_solver({10000, 19800, alike(chi), false}), SolverKind::pcg);
    EXPECT_EQ(choose_solver({40000, 79600, alike(chi), false}), SolverKind::pcg);
  }
  for (const double chi : {32.0, 200.0})
    EXPECT_EQ(choose_solver({10000, 19800, alike(chi), false}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({10000, 9999, alike(0.3), false}), SolverKind::cholesky);
}

TEST(ChooseSolver, IteratesWhereTheMatrixChangesEveryStepUnlessItIsStiff) {
  EXPECT_EQ(choose_solver({200, 199, alike(0.02), true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({200, 199, alike(200.0), true}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({2500, 4900, alike(2.0), true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({2500, 4900, alike(200.0), true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({2500, 4900, alike(2e4), true}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({10000, 19800, alike(2.0), true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({10000, 19800, alike(200.0), true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({10000, 19800, alike(1e5), true}), SolverKind::cholesky);
}

// Random grains that fall: 97 with a splinter of chi = 5,190 take 5.6 s by PCG and 20 s by Cholesky, 401 with one of
// 7,740 9.4 and 26 s; rock of 210 blocks with one of 1e7 takes 31 and 10 s.
TEST(ChooseSolver, DoesNotGoByTheChiOfASplinterWhereTheMatrixChanges) {
  EXPECT_EQ(choose_solver({97, 247, {5190, 239}, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({401, 1100, {7740, 438}, true}), SolverKind::pcg);
  EXPECT_EQ(choose_solver({210, 600, {1.27e7, 1100}, true}), SolverKind::cholesky);
  EXPECT_EQ(choose_solver({2500, 4900, {200, 0.2}, false}), SolverKind::cholesky);
}

TEST(ChooseSolver, FactorsStaticSteps) {
  for (const double chi : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(choose_solver({10000, 19800, alike(chi), true}), SolverKind::cholesky);
  }
}

}  // namespace
}  // namespace dda
