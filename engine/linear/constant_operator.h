// A symmetric block matrix that no longer changes, laid out for products alone.
#pragma once

#include <cstddef>
#include <optional>
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
  // Looks at a matrix that must outlive the operator and stay where it is.
  explicit ConstantOperator(const BlockMatrix& matrix);
  // Takes the matrix over, and keeps it only where there are no rows.
  explicit ConstantOperator(BlockMatrix&& matrix);
  // Blocks on the diagonal alone, that of each row being one of `blocks`.
  ConstantOperator(const std::vector<int>& which, std::vector<Mat6> blocks);
  ConstantOperator(const ConstantOperator&) = delete;
  ConstantOperator& operator=(const ConstantOperator&) = delete;

  // x and y hold 6n numbers each and are different vectors. Allocates nothing. Shared by threads where there are many
  // blocks.
  void multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& y, Phase phase = Phase::product) const;

  // Whether it has rows of its own, and the matrix is not asked any more.
  [[nodiscard]] bool has_rows() const { return !entries_.empty(); }
  [[nodiscard]] std::size_t different_blocks() const { return blocks_.size(); }

  [[nodiscard]] int size() const { return static_cast<int>(row_starts_.size()) - 1; }
  [[nodiscard]] int unknowns() const { return 6 * size(); }
  [[nodiscard]] int couplings() const { return couplings_; }  // as of the matrix

  // The block (row i, column j), zero where the pattern has none.
  [[nodiscard]] Mat6 block(int i, int j) const;
  // Calls visit(row, column, block) for all blocks of the lower triangle.
  template <typename Visit>
  void for_each_block(const Visit& visit) const;
  // A matrix of the same pattern that has no values yet (set_zero() is to come), and one of `factor` times the values.
  [[nodiscard]] BlockMatrix pattern() const;
  [[nodiscard]] BlockMatrix matrix(double factor = 1) const;

  struct Entry {
    int column;
    int block;  // of the different ones
  };

 private:
  void lay_out_rows();
  void take_blocks();

  std::optional<BlockMatrix> own_;
  const BlockMatrix* matrix_ = nullptr;  // only asked where there are no rows
  int couplings_ = 0;
  std::vector<int> row_starts_;  // n + 1
  std::vector<Entry> entries_;   // of each row by ascending columns
  std::vector<Mat6> blocks_;
};

template <typename Visit>
void ConstantOperator::for_each_block(const Visit& visit) const {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  if (!has_rows()) {
    for (int column = 0; column < size(); ++column)
      for (int k = matrix_->column_starts()[at(column)]; k < matrix_->column_starts()[at(column) + 1]; ++k)
        visit(matrix_->block_rows()[at(k)], column, matrix_->offdiagonal(k));
    return;
  }
  for (int row = 0; row < size(); ++row)
    for (int k = row_starts_[at(row)]; k < row_starts_[at(row) + 1] && entries_[at(k)].column <= row; ++k)
      visit(row, entries_[at(k)].column, blocks_[at(entries_[at(k)].block)]);
}

}  // namespace dda
