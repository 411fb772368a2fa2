#include "engine/linear/incomplete_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "engine/core/allocation_counter.h"
#include "engine/linear/block_order.h"
#include "engine/linear/dense_solver.h"
#include "engine/linear/random_system.h"

namespace dda {
namespace {

// The relative error of a solution where the factor is exact but for its single precision: measured 6e-7 at most. A
// block in a wrong place makes 1e-2 and more.
constexpr double single_precision = 5e-6;

Eigen::VectorXd applied(IncompleteCholesky& factor, const Eigen::VectorXd& r) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(r.size());
  const double product = factor.apply(r, z);
  EXPECT_NEAR(product, r.dot(z), 1e-13 * r.norm() * z.norm());
  return z;
}

IncompleteCholesky factored(const BlockMatrix& matrix, int level) {
  IncompleteCholesky factor;
  factor.analyze(matrix, level);
  EXPECT_TRUE(factor.factorize(matrix));
  return factor;
}

// (M D M^T)^-1 as a dense matrix.
Eigen::MatrixXd inverse_of(IncompleteCholesky& factor, Eigen::Index unknowns) {
  Eigen::MatrixXd inverse(unknowns, unknowns);
  for (Eigen::Index i = 0; i < unknowns; ++i) inverse.col(i) = applied(factor, Eigen::VectorXd::Unit(unknowns, i));
  return inverse;
}

TEST(IncompleteCholesky, IsExactWithAllFill) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const RandomSystem system = random_system(15, random_couplings(15, 30, seed), seed);
    IncompleteCholesky factor = factored(system.matrix, 15);
    const Eigen::VectorXd expected = system.dense.llt().solve(system.rhs);
    EXPECT_LE((applied(factor, system.rhs) - expected).norm(), single_precision * expected.norm());
  }
}

TEST(IncompleteCholesky, IsExactOnAChainWithoutFill) {
  const RandomSystem system = random_system(30, grid_couplings(30, 1), 3);
  IncompleteCholesky factor = factored(system.matrix, 0);
  EXPECT_EQ(factor.entries(), 29);
  const Eigen::VectorXd expected = system.dense.llt().solve(system.rhs);
  EXPECT_LE((applied(factor, system.rhs) - expected).norm(), single_precision * expected.norm());
}

// Halves are eliminated towards what couples them, so that a chain is as exact as in one piece.
TEST(IncompleteCholesky, IsExactOnAChainInHalves) {
  const int blocks = static_cast<int>(IncompleteCholesky::worth_halving) + 37;
  const LargeSystem system = large_chain(blocks, 0);
  IncompleteCholesky factor = factored(system.matrix, 0);
  EXPECT_EQ(factor.entries(), blocks - 1);
  const Eigen::VectorXd z = applied(factor, system.rhs);
  Eigen::VectorXd image(z.size());
  system.matrix.multiply(z, image);
  EXPECT_LE((image - system.rhs).norm(), 10 * single_precision * system.rhs.norm());
}

TEST(CutInHalves, LeavesNoCouplingBetweenThem) {
  const int side = 70;
  const BlockMatrix matrix(side * side, grid_couplings(side, side));
  std::vector<int> order = cuthill_mckee_order(matrix);
  const Halves halves = cut_in_halves(matrix, order);
  std::vector<std::size_t> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[static_cast<std::size_t>(order[k])] = k;
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), order.size());
  EXPECT_LE(order.size() - halves.second, 2U * side);
  EXPECT_LE(halves.second - halves.first, halves.first);
  for (const auto& [i, j] : grid_couplings(side, side)) {
    const auto [low, high] = std::minmax(position[static_cast<std::size_t>(i)], position[static_cast<std::size_t>(j)]);
    EXPECT_FALSE(low < halves.first && high >= halves.first && high < halves.second) << i << ' ' << j;
  }
}

TEST(CutInHalves, IsLeftWhereAllHangsTogether) {
  const BlockMatrix matrix(40, random_couplings(40, 700, 3U));
  std::vector<int> order = cuthill_mckee_order(matrix);
  EXPECT_EQ(cut_in_halves(matrix, order).second, 0U);
  EXPECT_EQ(order, cuthill_mckee_order(matrix));
}

// What defines an incomplete factor: M D M^T is A on the pattern of M, whatever it is elsewhere.
TEST(IncompleteCholesky, AgreesWithTheMatrixOnItsPattern) {
  RandomSystem system = random_system(36, grid_couplings(6, 6), 2);
  for (int i = 0; i < 36; ++i) system.matrix.diagonal(i) += 20 * Mat6::Identity();  // nothing indefinite
  system.dense += 20 * Eigen::MatrixXd::Identity(216, 216);
  IncompleteCholesky factor = factored(system.matrix, 0);
  EXPECT_EQ(factor.shift(), 0);
  const Eigen::MatrixXd product = inverse_of(factor, 216).inverse();
  double elsewhere = 0;
  for (int i = 0; i < 36; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double off = (product - system.dense).block<6, 6>(6 * i, 6 * j).cwiseAbs().maxCoeff();
      if (i == j || system.matrix.slot(i, j) >= 0) {
        EXPECT_LE(off, single_precision * system.dense.cwiseAbs().maxCoeff()) << i << ", " << j;
      } else {
        elsewhere = std::max(elsewhere, off);
      }
    }
  }
  EXPECT_GT(elsewhere, 1e-3) << "nothing was dropped";
}

// Every level takes what the one before left out nearest to the pattern.
TEST(IncompleteCholesky, ComesNearerWithEveryLevel) {
  const RandomSystem system = random_system(100, grid_couplings(10, 10), 4);
  double before = std::numeric_limits<double>::infinity();
  int entries = -1;
  for (const int level : {IncompleteCholesky::diagonal, 0, 1, 2, 4, 20}) {
    IncompleteCholesky factor = factored(system.matrix, level);
    const Eigen::VectorXd error = applied(factor, system.dense * system.rhs) - system.rhs;
    EXPECT_LT(error.norm(), before) << "level " << level;
    EXPECT_GT(factor.entries(), entries);
    before = error.norm();
    entries = factor.entries();
  }
  EXPECT_LE(before, single_precision * system.rhs.norm());
}

TEST(IncompleteCholesky, TakesDiagonalBlocksAlone) {
  const RandomSystem system = random_system(9, grid_couplings(3, 3), 6);
  IncompleteCholesky factor = factored(system.matrix, IncompleteCholesky::diagonal);
  const Eigen::VectorXd z = applied(factor, system.rhs);
  for (int i = 0; i < 9; ++i) {
    const Vec6 own = system.rhs.segment<6>(6 * i);
    EXPECT_LE((system.matrix.diagonal(i) * z.segment<6>(6 * i) - own).norm(), single_precision * own.norm());
  }
}

// Unit squares held by nothing but corner springs: what is dropped makes plain incomplete factors indefinite.
BlockMatrix floppy_grid(int side) {
  BlockMatrix matrix(side * side, grid_couplings(side, side));
  for (int i = 0; i < side * side; ++i) matrix.diagonal(i).diagonal().setConstant(1e-3);
  for (const auto& [i, j] : grid_couplings(side, side)) {
    const Vec2 step = j == i + side ? Vec2(0, 1) : Vec2(1, 0);
    for (const double end : {-0.5, 0.5}) {
      const Vec2 corner = 0.5 * step + end * Vec2(-step.y(), step.x());
      const Mat26 on_i = displacement_rows(corner);
      const Mat26 on_j = displacement_rows(corner - step);
      matrix.add_coupling(i, i, on_i.transpose() * on_i);
      matrix.add_coupling(j, j, on_j.transpose() * on_j);
      matrix.add_coupling(i, j, -on_i.transpose() * on_j);
    }
  }
  return matrix;
}

TEST(IncompleteCholesky, StaysPositiveDefiniteWhereDroppingWouldNot) {
  const BlockMatrix matrix = floppy_grid(12);
  for (const int level : {0, 1, 2, 3}) {
    IncompleteCholesky factor = factored(matrix, level);
    if (level == 2) {
      EXPECT_GT(factor.shift(), 0) << "nothing was at stake";
    }
    const Eigen::MatrixXd inverse = inverse_of(factor, matrix.unknowns());
    EXPECT_LE((inverse - inverse.transpose()).cwiseAbs().maxCoeff(), single_precision * inverse.cwiseAbs().maxCoeff());
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(inverse).info(), Eigen::Success) << "level " << level;
  }
}

// The factor of a part is that of the matrix with its rows and columns alone: here with all fill, so that the answer is
// known. What another part or the whole left in the factor before is of no effect.
TEST(IncompleteCholesky, OfAPartIsThatOfItsRowsAndColumns) {
  const RandomSystem system = random_system(15, random_couplings(15, 30, 4), 4);
  IncompleteCholesky factor = factored(system.matrix, 15);
  for (const std::vector<int>& blocks : {std::vector<int>{12, 3, 4, 8}, {0, 1, 2, 3, 5, 7, 11, 13, 14}, {6}}) {
    BlockPart part;
    part.clear(15);
    for (const int block : blocks) part.add(block);
    ASSERT_TRUE(factor.factorize(system.matrix, part));
    Eigen::MatrixXd alone = Eigen::MatrixXd::Identity(90, 90);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(90);
    for (const int i : blocks) {
      rhs.segment<6>(6 * i) = system.rhs.segment<6>(6 * i);
      for (const int j : blocks) alone.block<6, 6>(6 * i, 6 * j) = system.dense.block<6, 6>(6 * i, 6 * j);
    }
    const Eigen::VectorXd expected = alone.llt().solve(rhs);
    Eigen::VectorXd z = Eigen::VectorXd::Constant(90, 7);
    EXPECT_NEAR(factor.apply(system.rhs, z), rhs.dot(expected), single_precision * rhs.norm() * expected.norm());
    EXPECT_LE((z - expected).norm(), single_precision * expected.norm());
  }
  ASSERT_TRUE(factor.factorize(system.matrix));
  const Eigen::VectorXd whole = system.dense.llt().solve(system.rhs);
  EXPECT_LE((applied(factor, system.rhs) - whole).norm(), single_precision * whole.norm());
}

// Numbers beyond the range of single precision are no different.
TEST(IncompleteCholesky, DoesNotDependOnUnits) {
  RandomSystem system = random_system(30, grid_couplings(6, 5), 3);
  IncompleteCholesky factor = factored(system.matrix, 1);
  const Eigen::VectorXd expected = applied(factor, system.rhs);
  for (const double unit : {1e-60, 1e60}) {
    BlockMatrix scaled(30, grid_couplings(6, 5));
    for (int i = 0; i < 30; ++i) scaled.diagonal(i) = unit * system.matrix.diagonal(i);
    for (const auto& [i, j] : grid_couplings(6, 5))
      scaled.offdiagonal(scaled.slot(j, i)) = unit * system.matrix.offdiagonal(system.matrix.slot(j, i));
    IncompleteCholesky other = factored(scaled, 1);
    const Eigen::VectorXd z = applied(other, 1e-50 * system.rhs) * unit / 1e-50;
    EXPECT_LE((z - expected).norm(), single_precision * expected.norm());
  }
  EXPECT_TRUE(applied(factor, Eigen::VectorXd::Zero(180)).isZero(0));
}

TEST(IncompleteCholesky, ReportsAnIndefiniteDiagonalBlock) {
  RandomSystem system = random_system(4, grid_couplings(4, 1), 1);
  system.matrix.diagonal(2).setZero();
  for (const int level : {IncompleteCholesky::diagonal, 1}) {
    IncompleteCholesky factor;
    factor.analyze(system.matrix, level);
    EXPECT_FALSE(factor.factorize(system.matrix));
  }
}

TEST(IncompleteCholesky, AllocatesNothingOnceAnalyzed) {
  const RandomSystem system = random_system(100, grid_couplings(10, 10), 1);
  IncompleteCholesky factor;
  factor.analyze(system.matrix, 2);
  Eigen::VectorXd z = system.rhs;
  const long before = allocations_so_far();
  const bool factorized = factor.factorize(system.matrix);
  factor.apply(system.rhs, z);
  EXPECT_EQ(allocations_so_far() - before, 0);
  EXPECT_TRUE(factorized);
}

// A floor under 40 blocks in a row must come last, or its elimination couples all of them.
// A push on one end of a chain whose blocks hand a hundredth of it on: beyond 19 of them single precision has fewer and
// fewer digits, which takes a hundred times as long to work with.
TEST(IncompleteCholesky, HasNoNumbersTooSmallForAllTheirDigits) {
  constexpr int blocks = 40;
  BlockMatrix chain(blocks, grid_couplings(blocks, 1));
  for (int i = 0; i < blocks; ++i) chain.add_coupling(i, i, Mat6::Identity());
  for (int i = 0; i + 1 < blocks; ++i) chain.add_coupling(i, i + 1, -0.01 * Mat6::Identity());
  for (const int level : {0, 1}) {
    IncompleteCholesky factor = factored(chain, level);
    const Eigen::VectorXd z = applied(factor, Eigen::VectorXd::Unit(6 * blocks, 0));
    EXPECT_NEAR(z(6 * 15), 1e-30, 1e-32);
    for (const double entry : z)
      EXPECT_TRUE(entry == 0 || std::abs(entry) >= static_cast<double>(std::numeric_limits<float>::min())) << entry;
  }
  volatile double tiny = 1e-300;
  EXPECT_GT(tiny * 1e-15, 0);  // elsewhere it is as ever
}

TEST(CuthillMckeeOrder, NumbersEveryBlockOnceAndHubsLast) {
  auto couplings = grid_couplings(40, 1);
  for (int i = 0; i < 40; ++i) couplings.emplace_back(40, i);
  couplings.emplace_back(42, 43);  // another body; 41 touches nothing
  const BlockMatrix matrix(44, couplings);
  std::vector<int> order = cuthill_mckee_order(matrix);
  EXPECT_EQ(order.back(), 40);
  std::sort(order.begin(), order.end());
  std::vector<int> all(44);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
}

TEST(CuthillMckeeOrder, KeepsNeighboursNear) {
  const BlockMatrix matrix(400, grid_couplings(20, 20));
  const std::vector<int> order = cuthill_mckee_order(matrix);
  std::vector<int> position(400);
  for (int k = 0; k < 400; ++k) position[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])] = k;
  for (const auto& [i, j] : grid_couplings(20, 20))
    EXPECT_LE(std::abs(position[static_cast<std::size_t>(i)] - position[static_cast<std::size_t>(j)]), 21);
}

}  // namespace
}  // namespace dda
