#include "engine/linear/constant_operator.h"

#include <gtest/gtest.h>

#include <utility>

#include "engine/linear/dense_solver.h"
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

// A grid of equal blocks: the diagonal blocks of corners, edges and inside, and what couples two neighbours, both ways.
TEST(ConstantOperator, KeepsEqualBlocksOnce) {
  const auto couplings = grid_couplings(30, 20);
  BlockMatrix matrix(600, couplings);
  const Mat6 along = Mat6::Random(), across = Mat6::Random();
  for (const auto& [i, j] : couplings) {
    matrix.add_coupling(i, j, j == i + 1 ? along : across);
    matrix.diagonal(i) += Mat6::Identity();
    matrix.diagonal(j) += Mat6::Identity();
  }
  const ConstantOperator rows(matrix);
  EXPECT_EQ(rows.different_blocks(), 3U + 4U);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(3600);
  Eigen::VectorXd expected(3600), got(3600);
  matrix.multiply(x, expected);
  rows.multiply(x, got);
  EXPECT_LT((got - expected).norm(), 1e-14 * expected.norm());
}

// Blocks that begin to be equal late are not looked for, and beyond the cache the matrix itself multiplies.
TEST(ConstantOperator, LeavesManyDifferentBlocksToTheMatrix) {
  BlockMatrix matrix(50'001, {});
  for (int i = 0; i < matrix.size(); ++i) matrix.diagonal(i) = (1 + i) * Mat6::Identity();
  const ConstantOperator rows(matrix);
  EXPECT_FALSE(rows.has_rows());
  Eigen::VectorXd y(matrix.unknowns());
  rows.multiply(Eigen::VectorXd::Ones(matrix.unknowns()), y);
  EXPECT_EQ(y.tail<6>(), Vec6::Constant(50'001));
}

// Its blocks are those of the matrix to the last bit, whether it has rows or the matrix.
void expect_same_blocks(const ConstantOperator& constant, const BlockMatrix& matrix) {
  EXPECT_EQ(constant.unknowns(), matrix.unknowns());
  EXPECT_EQ(constant.couplings(), matrix.couplings());
  EXPECT_EQ(to_dense(constant.matrix()), to_dense(matrix));
  EXPECT_EQ(to_dense(constant.matrix(2)), 2 * to_dense(matrix));
  BlockMatrix pattern = constant.pattern();
  pattern.set_zero();
  EXPECT_TRUE(to_dense(pattern).isZero(0));
  EXPECT_EQ(pattern.couplings(), matrix.couplings());
  const Eigen::MatrixXd dense = to_dense(matrix);
  for (int i = 0; i < matrix.size(); ++i)
    for (int j = 0; j < matrix.size(); ++j)
      EXPECT_EQ(constant.block(i, j), (dense.block<6, 6>(6 * i, 6 * j))) << i << " " << j;
}

TEST(ConstantOperator, StandsForTheMatrixThatItTookOver) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const RandomSystem system = random_system(20, random_couplings(20, 30, seed), seed);
    BlockMatrix given = system.matrix;
    const ConstantOperator rows(std::move(given));
    ASSERT_TRUE(rows.has_rows());
    expect_same_blocks(rows, system.matrix);
  }
}

TEST(ConstantOperator, KeepsTheMatrixWhereThereAreNoRows) {
  BlockMatrix matrix(50'001, {{3, 1}});
  for (int i = 0; i < matrix.size(); ++i) matrix.diagonal(i) = (1 + i) * Mat6::Identity();
  const Mat6 coupling = Mat6::Random();
  matrix.add_coupling(3, 1, coupling);
  const ConstantOperator kept(std::move(matrix));
  ASSERT_FALSE(kept.has_rows());
  EXPECT_EQ(kept.block(3, 1), coupling);
  EXPECT_EQ(kept.block(1, 3), coupling.transpose());
  EXPECT_EQ(kept.block(4, 4), 5 * Mat6::Identity());
  EXPECT_TRUE(kept.block(4, 1).isZero(0));
  EXPECT_EQ(Mat6(kept.matrix(2).offdiagonal(kept.matrix().slot(3, 1))), 2 * coupling);
  Eigen::VectorXd y(kept.unknowns());
  kept.multiply(Eigen::VectorXd::Ones(kept.unknowns()), y);
  EXPECT_EQ(y.tail<6>(), Vec6::Constant(50'001));
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
