// For tests: random symmetric positive definite block systems with a known bound of their condition.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "engine/linear/block_matrix.h"

namespace dda {

struct RandomSystem {
  BlockMatrix matrix;
  Eigen::MatrixXd dense;  // the same matrix, summed up on its own without BlockMatrix
  Eigen::VectorXd rhs;

  // Relative difference that round-off can cause between two good solutions: the eigenvalues are at least 1 (see
  // below), so the condition number is at most the norm of A; times the unit round-off, times the number of unknowns.
  [[nodiscard]] double tolerance() const {
    return 2.3e-16 * static_cast<double>(dense.rows()) * dense.cwiseAbs().rowwise().sum().maxCoeff();
  }
};

// Each coupling is a random spring: K = G^T G with a random 6 x 12 matrix G, added to the four blocks of the pair; each
// block has the identity besides, so that no eigenvalue is below 1.
inline RandomSystem random_system(int blocks, const std::vector<std::pair<int, int>>& couplings, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&] { return uniform(generator); };
  RandomSystem system{BlockMatrix(blocks, couplings), Eigen::MatrixXd::Identity(6 * blocks, 6 * blocks),
                      Eigen::VectorXd::NullaryExpr(6 * blocks, random)};
  for (int i = 0; i < blocks; ++i) system.matrix.diagonal(i) += Mat6::Identity();
  for (const auto& [i, j] : couplings) {
    if (i == j) continue;
    const Mat6 left = Mat6::NullaryExpr(random);
    const Mat6 right = Mat6::NullaryExpr(random);
    const Mat6 mixed = left.transpose() * right;
    system.matrix.add_coupling(i, i, left.transpose() * left);
    system.matrix.add_coupling(j, j, right.transpose() * right);
    system.matrix.add_coupling(i, j, mixed);
    system.dense.block<6, 6>(6 * i, 6 * i) += left.transpose() * left;
    system.dense.block<6, 6>(6 * j, 6 * j) += right.transpose() * right;
    system.dense.block<6, 6>(6 * i, 6 * j) += mixed;
    system.dense.block<6, 6>(6 * j, 6 * i) += mixed.transpose();
  }
  return system;
}

inline std::vector<std::pair<int, int>> random_couplings(int blocks, int number, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> block(0, blocks - 1);
  std::vector<std::pair<int, int>> couplings(static_cast<std::size_t>(number));
  for (auto& [i, j] : couplings) {
    i = block(generator);
    j = block(generator);
  }
  return couplings;
}

// A grid of columns x rows blocks; one row is a chain.
inline std::vector<std::pair<int, int>> grid_couplings(int columns, int rows) {
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < columns * rows; ++i) {
    if ((i + 1) % columns != 0) couplings.emplace_back(i, i + 1);
    if (i + columns < columns * rows) couplings.emplace_back(i, i + columns);
  }
  return couplings;
}

struct LargeSystem {
  BlockMatrix matrix;
  Eigen::VectorXd rhs;
};

// Weaker random springs, without a dense matrix, between neighbours along a chain and `far` pairs of blocks far apart,
// so that shares of a product reach into each other.
inline LargeSystem large_chain(int blocks, int far) {
  auto couplings = random_couplings(blocks, far, 5U);
  for (int i = 0; i + 1 < blocks; ++i) couplings.emplace_back(i, i + 1);
  std::erase_if(couplings, [](const auto& pair) { return pair.first == pair.second; });
  LargeSystem system{BlockMatrix(blocks, couplings), Eigen::VectorXd::Random(6 * blocks)};
  for (int i = 0; i < blocks; ++i) system.matrix.diagonal(i) += Mat6::Identity();
  for (const auto& [i, j] : couplings) {
    const Mat6 left = 0.1 * Mat6::Random();
    const Mat6 right = 0.1 * Mat6::Random();
    system.matrix.add_coupling(i, i, left.transpose() * left);
    system.matrix.add_coupling(j, j, right.transpose() * right);
    system.matrix.add_coupling(i, j, left.transpose() * right);
  }
  return system;
}

}  // namespace dda
