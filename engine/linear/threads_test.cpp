// What threads share gives the same bits with one of them, two and four.
#include <gtest/gtest.h>

#include <functional>

#include "engine/core/allocation_counter.h"
#include "engine/linear/block_vectors.h"
#include "engine/linear/constant_operator.h"
#include "engine/linear/pcg_solver.h"
#include "engine/linear/random_system.h"

namespace dda {
namespace {

constexpr int many = 2 * static_cast<int>(stretch_worth_sharing) + 77;  // enough for all but sums in pieces

void expect_same_bits(const std::function<Eigen::VectorXd()>& compute) {
  const Eigen::VectorXd alone = compute();
  for (const int threads : {2, 4}) {
    const ThreadsInUse in_use(threads);
    for (int repeat = 0; repeat < 3; ++repeat) EXPECT_TRUE(compute() == alone) << threads << " threads";
  }
}

TEST(Threads, ProductsHaveTheSameBits) {
  const LargeSystem system = large_chain(1500, 1500 / 4);
  const ConstantOperator constant(system.matrix);
  expect_same_bits([&] {
    Eigen::VectorXd y = Eigen::VectorXd::Constant(system.rhs.size(), 7);  // must be overwritten, not added to
    system.matrix.multiply(system.rhs, y);
    return y;
  });
  expect_same_bits([&] {
    Eigen::VectorXd y(system.rhs.size());
    constant.multiply(system.rhs, y);
    return y;
  });
}

// There are as many blocks as make two threads eliminate half of them each.
TEST(Threads, FactorsInHalvesHaveTheSameBits) {
  const LargeSystem system = large_chain(static_cast<int>(IncompleteCholesky::worth_halving) + 5, 60);
  expect_same_bits([&] {
    IncompleteCholesky factor;
    factor.analyze(system.matrix, 1);
    EXPECT_TRUE(factor.factorize(system.matrix));
    Eigen::VectorXd z(system.rhs.size());
    factor.apply(system.rhs, z);
    return z;
  });
}

TEST(Threads, SolutionsHaveTheSameBits) {
  const LargeSystem system = large_chain(many, many / 4);
  for (const int fill : {IncompleteCholesky::diagonal, 1})
    expect_same_bits([&] {
      PcgSolver solver({.fill_level = fill});
      solver.analyze(system.matrix);
      EXPECT_EQ(solver.factorize(system.matrix), Status::ok);
      Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
      EXPECT_EQ(solver.solve(system.rhs, x), Status::ok);
      return x;
    });
}

TEST(Threads, SumsInPiecesHaveTheSameBits) {
  const Eigen::VectorXd a = Eigen::VectorXd::Random(6 * (2 * static_cast<Eigen::Index>(blocks_of_plain_sum) + 77));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(a.size());
  expect_same_bits([&] { return Eigen::VectorXd::Constant(1, dot(a, b)); });
  EXPECT_NE(dot(a, b), a.dot(b));  // in another order
  const Eigen::Index few = 6 * (2 * static_cast<Eigen::Index>(blocks_of_plain_sum) - 1);
  EXPECT_EQ(dot(a.head(few), b.head(few)), a.head(few).dot(b.head(few)));
}

// More blocks than sums take in one piece, each by itself: the use of the preconditioner, and its sum.
TEST(Threads, DiagonalBlocksHaveTheSameBits) {
  BlockMatrix matrix(2 * static_cast<int>(blocks_of_plain_sum) + 77, {});
  for (int i = 0; i < matrix.size(); ++i) matrix.diagonal(i) = (1 + i % 7) * Mat6::Identity();
  IncompleteCholesky factor;
  factor.analyze(matrix, IncompleteCholesky::diagonal);
  ASSERT_TRUE(factor.factorize(matrix));
  const Eigen::VectorXd r = Eigen::VectorXd::Random(matrix.unknowns());
  expect_same_bits([&] {
    Eigen::VectorXd z(r.size() + 1);
    Eigen::VectorXd only_z(r.size());
    z(r.size()) = factor.apply(r, only_z);
    z.head(r.size()) = only_z;
    return z;
  });
}

// The longer chain is factored in halves, and its sums are shared.
TEST(Threads, WarmSolutionsAllocateNothing) {
  const ThreadsInUse in_use(2);
  for (const int blocks : {many, static_cast<int>(IncompleteCholesky::worth_halving) + 5}) {
    const LargeSystem system = large_chain(blocks, 60);
    PcgSolver solver({.fill_level = 1});
    solver.analyze(system.matrix);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.rhs.size());
    long before = 0;
    for (int i = 0; i < 2; ++i) {
      before = allocations_so_far();
      ASSERT_EQ(solver.factorize(system.matrix), Status::ok);
      x.setZero();
      ASSERT_EQ(solver.solve(system.rhs, x), Status::ok);
    }
    EXPECT_EQ(allocations_so_far(), before);
  }
}

}  // namespace
}  // namespace dda
