// Forward and backward substitution with a sparse Cholesky factor of 6x6 blocks: the innermost loop of a run that
// reuses its factor.
#pragma once

#include <span>
#include <vector>

#include "dda/core/types.h"

namespace dda {

// Takes over a scalar factor P A P^T = L L^T and keeps it as M D M^T with M unit lower triangular by blocks:
// M_ij = L_ij L_jj^-1, D_j = L_jj L_jj^T. One step along a chain of blocks then waits for one small product only (the
// divisions by L_jj are not in its way), and fixed sizes need no index for each number. D_j^-1 is applied as
// L_jj^-T L_jj^-1, which costs half of the digits that an explicit inverse of D_j may cost.
class BlockSubstitution {
 public:
  // A scalar factor as CSC: the diagonal entry first, rows ascending, and columns 6j ... 6j + 5 with the same rows
  // below the diagonal block, whole blocks of them.
  struct ScalarFactor {
    const int* column_starts;
    const int* rows;
    const double* values;
  };

  // Reads the pattern; order[k] is the block eliminated as the k-th.
  void set_pattern(const ScalarFactor& factor, std::span<const int> order);
  [[nodiscard]] bool has_pattern() const { return !column_starts_.empty(); }

  // Reads the values of a factor with that pattern. Allocates nothing.
  void set_values(const ScalarFactor& factor);

  // x = A^-1 rhs. Allocates nothing.
  void solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x);

 private:
  void forward();
  void backward(Eigen::VectorXd& x);

  std::vector<int> order_;
  std::vector<int> column_starts_;       // of the blocks of M below the diagonal
  std::vector<int> rows_;                // 6 * block row, for each of them
  std::vector<Mat6> blocks_;             // M_ij
  std::vector<Mat6> diagonal_inverses_;  // L_jj^-1, lower triangular
  Eigen::VectorXd work_;                 // in the order of elimination
};

}  // namespace dda
