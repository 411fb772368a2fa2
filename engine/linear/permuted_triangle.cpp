#include "engine/linear/permuted_triangle.h"

#include <algorithm>

namespace dda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<int> inverse_permutation(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[index(order[k])] = static_cast<int>(k);
  return position;
}

}  // namespace

PermutedTriangle::PermutedTriangle(const BlockMatrix& matrix, const std::vector<int>& order, Side side) {
  const std::vector<int> position = inverse_permutation(order);
  std::vector<std::vector<std::pair<int, Copy>>> columns(order.size());  // permuted row, block
  for (int j = 0; j < matrix.size(); ++j) {
    for (int k = matrix.column_starts()[index(j)]; k < matrix.column_starts()[index(j) + 1]; ++k) {
      int row = position[index(matrix.block_rows()[index(k)])];
      int column = position[index(j)];
      const bool transposed = side == Side::lower ? row < column : row > column;
      if (transposed) std::swap(row, column);
      columns[index(column)].push_back({row, {k, 0, 0, transposed}});
    }
  }
  for (auto& column : columns) {
    std::sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  build_scalar_csc(columns, side);
}

void PermutedTriangle::build_scalar_csc(const std::vector<std::vector<std::pair<int, Copy>>>& columns, Side side) {
  column_pointers_ = {0};
  for (const auto& column : columns) {
    const int start = static_cast<int>(row_indices_.size());
    const int stride = 6 * static_cast<int>(column.size());
    for (std::size_t k = 0; k < column.size(); ++k) {
      const Copy& copy = column[k].second;
      copies_.push_back({copy.source, start + 6 * static_cast<int>(k), stride, copy.transposed});
    }
    diagonal_places_.push_back(side == Side::lower ? start : start + stride - 6);
    diagonal_strides_.push_back(stride);
    for (int c = 0; c < 6; ++c) {
      for (const auto& [row, copy] : column) {
        for (int r = 0; r < 6; ++r) row_indices_.push_back(6 * row + r);
      }
      column_pointers_.push_back(static_cast<int>(row_indices_.size()));
    }
  }
  values_.assign(row_indices_.size(), 0.0);
}

void PermutedTriangle::update(const BlockMatrix& matrix) {
  for (const Copy& copy : copies_) {
    BlockMatrix::Block target(values_.data() + copy.offset, Eigen::OuterStride<>(copy.stride));
    if (copy.transposed) {
      target = matrix.offdiagonal(copy.source).transpose();
    } else {
      target = matrix.offdiagonal(copy.source);
    }
  }
}

double PermutedTriangle::diagonal(int k) const {
  const std::size_t block = index(k / 6);
  return values_[index(diagonal_places_[block] + (k % 6) * (diagonal_strides_[block] + 1))];
}

}  // namespace dda
