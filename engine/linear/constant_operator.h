// A symmetric block matrix that no longer changes, laid out for products alone.
#pragma once

#include <vector>

#include "engine/linear/block_matrix.h"

namespace dda {

// y = A x with both triangles stored, row by row in contiguous 6x6 blocks: every block is read once and added straight
// into its row, where BlockMatrix::multiply has to scatter and to sum across columns. Twice the memory of a
// BlockMatrix; about half the instructions of its product.
class ConstantOperator {
 public:
  explicit ConstantOperator(const BlockMatrix& matrix);

  // x and y hold 6n numbers each and are different vectors. Allocates nothing. Shared by threads where there are many
  // blocks.
  void multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& y) const;

 private:
  void multiply_rows(std::size_t first, std::size_t last, const double* x, double* y) const;

  std::vector<int> row_starts_;  // n + 1
  std::vector<int> columns_;
  std::vector<Mat6> blocks_;
};

}  // namespace dda
