#include "engine/linear/constant_operator.h"

#include <cstddef>

#include "engine/core/phase_clock.h"
#include "engine/linear/block_vectors.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

ConstantOperator::ConstantOperator(const BlockMatrix& matrix) : row_starts_(at(matrix.size()) + 1, 0) {
  struct Entry {
    int column;
    Mat6 block;
  };
  std::vector<std::vector<Entry>> rows(at(matrix.size()));
  for (int column = 0; column < matrix.size(); ++column) {
    rows[at(column)].push_back({column, matrix.diagonal(column)});
    for (int k = matrix.column_starts()[at(column)] + 1; k < matrix.column_starts()[at(column) + 1]; ++k) {
      const int row = matrix.block_rows()[at(k)];
      rows[at(row)].push_back({column, matrix.offdiagonal(k)});
      rows[at(column)].push_back({row, matrix.offdiagonal(k).transpose()});
    }
  }
  for (int row = 0; row < matrix.size(); ++row) {
    for (const Entry& entry : rows[at(row)]) {
      columns_.push_back(entry.column);
      blocks_.push_back(entry.block);
    }
    row_starts_[at(row) + 1] = static_cast<int>(columns_.size());
  }
}

void ConstantOperator::multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& y) const {
  const PhaseScope scope(Phase::product);
  parallel_for(row_starts_.size() - 1, blocks_worth_sharing,
               [&](std::size_t first, std::size_t last) { multiply_rows(first, last, x.data(), y.data()); });
}

void ConstantOperator::multiply_rows(std::size_t first, std::size_t last, const double* x, double* y) const {
  for (std::size_t row = first; row < last; ++row) {
    Vec6 sum = Vec6::Zero();
    for (int k = row_starts_[row]; k < row_starts_[row + 1]; ++k) {
      const Mat6& block = blocks_[at(k)];
      const double* factor = x + static_cast<std::ptrdiff_t>(6) * columns_[at(k)];
      for (int column = 0; column < 6; ++column) sum += factor[column] * block.col(column);
    }
    Vec6::Map(y + 6 * row) = sum;
  }
}

}  // namespace dda
