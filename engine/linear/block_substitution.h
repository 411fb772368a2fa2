// Forward and backward substitution with a sparse Cholesky factor of 6x6 blocks: the innermost loop of a run that
// reuses its factor.
#pragma once

#include <vector>

#include "engine/core/types.h"

namespace dda {

// Takes over a scalar factor P A P^T = L L^T and keeps it as M D M^T with M unit lower triangular by blocks:
// M_ij = L_ij L_jj^-1, D_j = L_jj L_jj^T. One step along a chain of blocks then waits for one small product only (the
// divisions by L_jj are not in its way), and fixed sizes need no index for each number. D_j^-1 is applied as
// L_jj^-T L_jj^-1, which costs half of the digits that an explicit inverse of D_j may cost.
class BlockSubstitution {
 public:
  // Where the scalar factor keeps its numbers: column c has its diagonal entry at diagonal_places[c], the entries below
  // it follow, rows ascending, and the six columns of a block have the same rows below their diagonal block.
  struct Pattern {
    std::vector<int> order;            // order[k]: the block eliminated as the k-th
    std::vector<int> column_starts;    // n + 1, into rows
    std::vector<int> rows;             // block rows below the diagonal block, column by column
    std::vector<int> diagonal_places;  // 6n
  };
  // The pattern of a factor kept as CSC of scalars, rows ascending.
  [[nodiscard]] static Pattern pattern_of_csc(const std::vector<int>& order, const int* column_starts, const int* rows);

  BlockSubstitution() = default;
  explicit BlockSubstitution(Pattern pattern);
  [[nodiscard]] bool has_pattern() const { return !pattern_.column_starts.empty(); }

  [[nodiscard]] int diagonal_place(int k) const { return pattern_.diagonal_places[static_cast<std::size_t>(k)]; }

  // Reads the values of the scalar factor. Allocates nothing.
  void set_values(const double* values);

  // x = A^-1 rhs. Allocates nothing.
  void solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x);

 private:
  void forward();
  void backward(Eigen::VectorXd& x);

  Pattern pattern_;
  std::vector<Mat6> blocks_;             // M_ij, as in pattern_.rows
  std::vector<Mat6> diagonal_inverses_;  // L_jj^-1, lower triangular
  Eigen::VectorXd work_;                 // in the order of elimination
};

}  // namespace dda
