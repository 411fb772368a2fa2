#include "engine/linear/block_substitution.h"

#include <utility>

#include "engine/linear/triangular_inverse.h"

namespace dda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// `places` are those of the diagonal entries of the six columns of the block.
Mat6 diagonal_block(const double* values, const int* places) {
  Mat6 block = Mat6::Zero();
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r) block(r, c) = values[places[c] + r - c];
  }
  return block;
}

Mat6 offdiagonal_block(const double* values, const int* places, int number) {
  Mat6 block;
  for (int c = 0; c < 6; ++c) block.col(c) = Eigen::Map<const Vec6>(values + places[c] + (6 - c) + 6 * number);
  return block;
}

}  // namespace

BlockSubstitution::Pattern BlockSubstitution::pattern_of_csc(const std::vector<int>& order, const int* column_starts,
                                                             const int* rows) {
  const int blocks = static_cast<int>(order.size());
  Pattern pattern{order, {0}, {}, {column_starts, column_starts + 6 * blocks}};
  for (int j = 0; j < blocks; ++j) {
    for (int k = column_starts[6 * j] + 6; k < column_starts[6 * j + 1]; k += 6) pattern.rows.push_back(rows[k] / 6);
    pattern.column_starts.push_back(static_cast<int>(pattern.rows.size()));
  }
  return pattern;
}

BlockSubstitution::BlockSubstitution(Pattern pattern)
    : pattern_(std::move(pattern)),
      blocks_(pattern_.rows.size()),
      diagonal_inverses_(pattern_.order.size()),
      work_(6 * static_cast<Eigen::Index>(pattern_.order.size())) {}

void BlockSubstitution::set_values(const double* values) {
  for (int j = 0; j < static_cast<int>(pattern_.order.size()); ++j) {
    const int* places = pattern_.diagonal_places.data() + 6 * j;
    const Mat6 inverse = inverse_of_lower(diagonal_block(values, places));
    diagonal_inverses_[index(j)] = inverse;
    const int first = pattern_.column_starts[index(j)];
    for (int k = first; k < pattern_.column_starts[index(j) + 1]; ++k) {
      blocks_[index(k)].noalias() = offdiagonal_block(values, places, k - first).lazyProduct(inverse);
    }
  }
}

void BlockSubstitution::solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  for (std::size_t j = 0; j < pattern_.order.size(); ++j) {
    work_.segment<6>(6 * static_cast<Eigen::Index>(j)) = rhs.segment<6>(6 * pattern_.order[j]);
  }
  forward();
  backward(x);
}

void BlockSubstitution::forward() {
  for (int j = 0; j < static_cast<int>(pattern_.order.size()); ++j) {
    const Vec6 known = work_.segment<6>(6 * j);
    for (int k = pattern_.column_starts[index(j)]; k < pattern_.column_starts[index(j) + 1]; ++k) {
      work_.segment<6>(6 * pattern_.rows[index(k)]) -= blocks_[index(k)] * known;
    }
  }
}

void BlockSubstitution::backward(Eigen::VectorXd& x) {
  for (int j = static_cast<int>(pattern_.order.size()) - 1; j >= 0; --j) {
    const Mat6& inverse = diagonal_inverses_[index(j)];
    const Vec6 halfway = inverse * work_.segment<6>(6 * j);
    Vec6 result = inverse.transpose() * halfway;
    for (int k = pattern_.column_starts[index(j)]; k < pattern_.column_starts[index(j) + 1]; ++k) {
      result -= blocks_[index(k)].transpose() * work_.segment<6>(6 * pattern_.rows[index(k)]);
    }
    work_.segment<6>(6 * j) = result;
    x.segment<6>(6 * pattern_.order[index(j)]) = result;
  }
}

}  // namespace dda
