#include "engine/linear/constant_operator.h"

#include <gtest/gtest.h>

#include "engine/linear/random_system.h"

namespace dda {
namespace {

// The same sums as BlockMatrix::multiply in another order: round-off of some tens of terms of order one.
TEST(ConstantOperator, MultipliesAsTheMatrixItCameFrom) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const RandomSystem system = random_system(40, random_couplings(40, 60, seed), seed);
    const BlockMatrix& matrix = system.matrix;
    const Eigen::VectorXd& x = system.rhs;
    Eigen::VectorXd expected(x.size());
    Eigen::VectorXd got = Eigen::VectorXd::Constant(x.size(), 7);  // must be overwritten, not added to
    matrix.multiply(x, expected);
    ConstantOperator(matrix).multiply(x, got);
    EXPECT_LT((got - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(ConstantOperator, KeepsUncoupledBlocksApart) {
  BlockMatrix matrix(2, {});
  matrix.diagonal(0) = 2 * Mat6::Identity();
  matrix.diagonal(1) = 3 * Mat6::Identity();
  Eigen::VectorXd y(12);
  ConstantOperator(matrix).multiply(Eigen::VectorXd::Ones(12), y);
  EXPECT_EQ(y.head<6>(), Vec6::Constant(2));
  EXPECT_EQ(y.tail<6>(), Vec6::Constant(3));
}

}  // namespace
}  // namespace dda
