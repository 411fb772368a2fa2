#include "engine/linear/block_matrix.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/linear/dense_solver.h"
#include "engine/linear/permuted_triangle.h"
#include "engine/linear/random_system.h"

namespace dda {
namespace {

// The lower triangle that a reader of the scalar CSC sees, mirrored; a row out of order counts as an error.
Eigen::MatrixXd dense_of_csc(int unknowns, const int* columns, const int* rows, const double* values, bool lower) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (int c = 0; c < unknowns; ++c) {
    for (int k = columns[c]; k < columns[c + 1]; ++k) {
      if (k > columns[c]) {
        EXPECT_LT(rows[k - 1], rows[k]);
      }
      if (lower ? rows[k] < c : rows[k] > c) continue;
      dense(rows[k], c) = dense(c, rows[k]) = values[k];
    }
  }
  return dense;
}

TEST(BlockMatrix, PatternIgnoresOrderDuplicatesAndSelfPairs) {
  const BlockMatrix matrix(4, {{3, 1}, {0, 2}, {1, 3}, {2, 2}, {2, 0}, {0, 1}});
  EXPECT_EQ(matrix.size(), 4);
  EXPECT_EQ(matrix.unknowns(), 24);
  EXPECT_EQ(matrix.couplings(), 3);
  EXPECT_GE(matrix.slot(1, 0), 0);
  EXPECT_GE(matrix.slot(2, 0), 0);
  EXPECT_GE(matrix.slot(3, 1), 0);
  EXPECT_EQ(matrix.slot(3, 0), -1);
  EXPECT_EQ(matrix.slot(3, 2), -1);
  EXPECT_EQ(matrix.slot(0, 1), -1);
  EXPECT_EQ(matrix.slot(2, 2), -1);
  EXPECT_EQ(matrix.slot(4, 0), -1);
  EXPECT_EQ(matrix.slot(0, -1), -1);
}

TEST(BlockMatrix, RejectsWhatIsOutside) {
  EXPECT_THROW(BlockMatrix(3, {{0, 3}}), std::invalid_argument);
  EXPECT_THROW(BlockMatrix(3, {{-1, 0}}), std::invalid_argument);
  EXPECT_THROW(BlockMatrix(-1, {}), std::invalid_argument);
  BlockMatrix matrix(3, {{0, 1}});
  EXPECT_THROW(matrix.add_coupling(2, 0, Mat6::Identity()), std::out_of_range);
  EXPECT_THROW(matrix.add_coupling(3, 3, Mat6::Identity()), std::out_of_range);
}

TEST(BlockMatrix, WithoutBlocksIsEmpty) {
  const BlockMatrix matrix(0, {});
  EXPECT_EQ(matrix.unknowns(), 0);
}

// Exact: both sides add the same numbers in the same order.
TEST(BlockMatrix, PanelsAreTheDenseMatrix) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const RandomSystem system = random_system(9, random_couplings(9, 20, seed), seed);
    EXPECT_EQ(to_dense(system.matrix), system.dense);
  }
}

TEST(BlockMatrix, SlotsAddressTheBlocks) {
  RandomSystem system = random_system(9, random_couplings(9, 20, 7), 7);
  for (int j = 0; j < 9; ++j) {
    for (int i = j + 1; i < 9; ++i) {
      const int slot = system.matrix.slot(i, j);
      const Mat6 expected = system.dense.block<6, 6>(6 * i, 6 * j);
      EXPECT_EQ(slot < 0, expected.isZero(0));
      if (slot >= 0) {
        EXPECT_EQ(Mat6(system.matrix.offdiagonal(slot)), expected);
      }
    }
  }
  system.matrix.set_zero();
  EXPECT_TRUE(to_dense(system.matrix).isZero(0));
}

// A row of A x sums fewer than 9 * 6 products: 54 roundings of its largest partial sum.
TEST(BlockMatrix, MultipliesAsTheDenseMatrix) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const RandomSystem system = random_system(9, random_couplings(9, 20, seed), seed);
    Eigen::VectorXd product = Eigen::VectorXd::Constant(54, 7.0);
    system.matrix.multiply(system.rhs, product);
    const Eigen::VectorXd bound = system.dense.cwiseAbs() * system.rhs.cwiseAbs() * (54 * 2.3e-16);
    EXPECT_TRUE(((product - system.dense * system.rhs).cwiseAbs().array() <= bound.array()).all());
  }
}

// A vector that is zero outside of a part: nothing of the product is lost, in the part or beside it.
TEST(BlockMatrix, MultipliesWhatIsNotZeroInAPartAlone) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const RandomSystem system = random_system(9, random_couplings(9, 12, seed), seed);
    BlockPart part;
    part.clear(9);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(54);
    for (const int block : {7, 2, 3}) {
      part.add(block);
      x.segment<6>(6 * block) = system.rhs.segment<6>(6 * block);
    }
    Eigen::VectorXd expected(54), product = Eigen::VectorXd::Constant(54, 7.0);
    system.matrix.multiply(x, expected);
    system.matrix.multiply(part, x, product);
    const Eigen::VectorXd bound = system.dense.cwiseAbs() * x.cwiseAbs() * (54 * 2.3e-16);
    EXPECT_TRUE(((product - expected).cwiseAbs().array() <= bound.array()).all());
  }
}

TEST(BlockPart, KeepsTheOrderAndNoBlockTwice) {
  BlockPart part;
  part.clear(5);
  for (const int block : {3, 1, 3, 4}) part.add(block);
  EXPECT_EQ(part.blocks(), (std::vector<int>{3, 1, 4}));
  EXPECT_TRUE(part.contains(4));
  EXPECT_FALSE(part.contains(0));
  EXPECT_TRUE(part.among_first(2, 1));
  EXPECT_FALSE(part.among_first(2, 4));
  EXPECT_FALSE(part.among_first(2, 0));
  part.clear(5);
  EXPECT_EQ(part.size(), 0);
  EXPECT_FALSE(part.contains(3));
}

TEST(PermutedTriangle, IsTheMatrixInTheOrderOfElimination) {
  const RandomSystem system = random_system(6, random_couplings(6, 9, 3), 3);
  const std::vector<int> order = {4, 0, 5, 2, 1, 3};
  Eigen::MatrixXd expected(36, 36);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      expected.block<6, 6>(6 * i, 6 * j) =
          system.dense.block<6, 6>(6 * order[static_cast<std::size_t>(i)], 6 * order[static_cast<std::size_t>(j)]);
    }
  }
  for (const bool lower : {true, false}) {
    const auto side = lower ? PermutedTriangle::Side::lower : PermutedTriangle::Side::upper;
    PermutedTriangle copy(system.matrix, order, side);
    copy.update(system.matrix);
    EXPECT_EQ(dense_of_csc(36, copy.column_pointers().data(), copy.row_indices().data(), copy.values().data(), lower),
              expected);
    for (int k = 0; k < 36; ++k) EXPECT_EQ(copy.diagonal(k), expected(k, k));
  }
}

}  // namespace
}  // namespace dda
