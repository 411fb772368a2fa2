// A symmetric block matrix that no longer changes, laid out for products alone.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/phase_clock.h"
#include "engine/linear/block_matrix.h"

namespace dda {

// y = A x with both triangles stored, row by row in 6x6 blocks: every row is summed up by itself, where
// BlockMatrix::multiply has to scatter and to sum across columns. Blocks that are equal to the last bit are kept once:
// a grid of equal blocks has a few dozen different ones, which stay in the first cache. Where so many differ that they
// leave the cache, fetching both triangles takes longer than the sums save, and the matrix itself multiplies.
class ConstantOperator {
 public:
  // The matrix must outlive the operator and stay where it is.
  explicit ConstantOperator(const BlockMatrix& matrix);

  // x and y hold 6n numbers each and are different vectors. Allocates nothing. Shared by threads where there are many
  // blocks.
  void multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& y, Phase phase = Phase::product) const;

  // Whether it has rows of its own.
  [[nodiscard]] bool has_rows() const { return !entries_.empty(); }
  [[nodiscard]] std::size_t different_blocks() const { return blocks_.size(); }

  struct Entry {
    int column;
    int block;  // of the different ones
  };

 private:
  void lay_out_rows();
  void take_blocks();

  const BlockMatrix& matrix_;
  std::vector<int> row_starts_;  // n + 1
  std::vector<Entry> entries_;
  std::vector<Mat6> blocks_;
};

}  // namespace dda
