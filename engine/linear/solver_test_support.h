// For tests: systems that every solver has an answer to, and what is expected of those that take parts.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <stdexcept>

#include "engine/linear/random_system.h"
#include "engine/linear/solver.h"

namespace dda {

inline Eigen::VectorXd oracle(const RandomSystem& system) { return system.dense.llt().solve(system.rhs); }

// Springs 1e15 times as stiff as what holds the blocks: the residual that an iteration carries along becomes small, the
// true one does not. (The dense matrix has no part in it.)
inline RandomSystem spoilt_by_round_off() {
  RandomSystem system = random_system(30, grid_couplings(30, 1), 6);
  for (const auto& [i, j] : grid_couplings(30, 1)) {
    const Mat6 stiff = 1e15 * Mat6::Identity();
    system.matrix.add_coupling(i, i, stiff);
    system.matrix.add_coupling(j, j, stiff);
    system.matrix.add_coupling(i, j, -stiff);
  }
  return system;
}

// Diagonal blocks I, coupling 2 I: eigenvalues -1 and 3.
inline BlockMatrix indefinite_pair() {
  BlockMatrix matrix(2, {{0, 1}});
  for (int i = 0; i < 2; ++i) matrix.diagonal(i).setIdentity();
  matrix.add_coupling(1, 0, 2 * Mat6::Identity());
  return matrix;
}

// `solver` has analyzed the chain of six blocks that `system` is.
inline void expect_takes_a_part(LinearSolver& solver, const RandomSystem& system) {
  BlockPart part;
  part.clear(6);
  part.add(2);
  Eigen::VectorXd z = Eigen::VectorXd::Ones(36);
  ASSERT_EQ(solver.factorize(system.matrix, part), Status::ok);
  solver.precondition(system.rhs, z);
  EXPECT_NE(z.segment<6>(12).norm(), 0);
  z.segment<6>(12).setZero();
  EXPECT_EQ(z.norm(), 0);
  EXPECT_THROW(static_cast<void>(solver.solve(system.rhs, z)), std::logic_error);
}

}  // namespace dda
