#include "dda/linear/block_substitution.h"

namespace dda {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Mat6 diagonal_block(const BlockSubstitution::ScalarFactor& factor, int j) {
  Mat6 block = Mat6::Zero();
  for (int c = 0; c < 6; ++c) {
    const double* column = factor.values + factor.column_starts[6 * j + c];
    for (int r = c; r < 6; ++r) block(r, c) = column[r - c];
  }
  return block;
}

Mat6 offdiagonal_block(const BlockSubstitution::ScalarFactor& factor, int j, int number) {
  Mat6 block;
  for (int c = 0; c < 6; ++c) {
    const double* column = factor.values + factor.column_starts[6 * j + c] + (6 - c) + 6 * number;
    for (int r = 0; r < 6; ++r) block(r, c) = column[r];
  }
  return block;
}

Mat6 inverse_of_lower(const Mat6& lower) {
  Mat6 inverse = Mat6::Zero();
  for (int c = 0; c < 6; ++c) {
    inverse(c, c) = 1 / lower(c, c);
    for (int r = c + 1; r < 6; ++r) {
      double sum = 0;
      for (int k = c; k < r; ++k) sum += lower(r, k) * inverse(k, c);
      inverse(r, c) = -sum / lower(r, r);
    }
  }
  return inverse;
}

}  // namespace

void BlockSubstitution::set_pattern(const ScalarFactor& factor, std::span<const int> order) {
  const int blocks = static_cast<int>(order.size());
  order_.assign(order.begin(), order.end());
  column_starts_ = {0};
  rows_.clear();
  for (int j = 0; j < blocks; ++j) {
    for (int k = factor.column_starts[6 * j] + 6; k < factor.column_starts[6 * j + 1]; k += 6) {
      rows_.push_back(factor.rows[k]);
    }
    column_starts_.push_back(static_cast<int>(rows_.size()));
  }
  blocks_.resize(rows_.size());
  diagonal_inverses_.resize(order.size());
  work_.resize(6 * blocks);
}

void BlockSubstitution::set_values(const ScalarFactor& factor) {
  for (int j = 0; j < static_cast<int>(order_.size()); ++j) {
    const Mat6 inverse = inverse_of_lower(diagonal_block(factor, j));
    diagonal_inverses_[index(j)] = inverse;
    const int first = column_starts_[index(j)];
    for (int k = first; k < column_starts_[index(j) + 1]; ++k) {
      blocks_[index(k)].noalias() = offdiagonal_block(factor, j, k - first) * inverse;
    }
  }
}

void BlockSubstitution::solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  for (std::size_t j = 0; j < order_.size(); ++j) {
    work_.segment<6>(6 * static_cast<Eigen::Index>(j)) = rhs.segment<6>(6 * order_[j]);
  }
  forward();
  backward(x);
}

void BlockSubstitution::forward() {
  for (int j = 0; j < static_cast<int>(order_.size()); ++j) {
    const Vec6 known = work_.segment<6>(6 * j);
    for (int k = column_starts_[index(j)]; k < column_starts_[index(j) + 1]; ++k) {
      work_.segment<6>(rows_[index(k)]) -= blocks_[index(k)] * known;
    }
  }
}

void BlockSubstitution::backward(Eigen::VectorXd& x) {
  for (int j = static_cast<int>(order_.size()) - 1; j >= 0; --j) {
    const Mat6& inverse = diagonal_inverses_[index(j)];
    const Vec6 halfway = inverse * work_.segment<6>(6 * j);
    Vec6 result = inverse.transpose() * halfway;
    for (int k = column_starts_[index(j)]; k < column_starts_[index(j) + 1]; ++k) {
      result -= blocks_[index(k)].transpose() * work_.segment<6>(rows_[index(k)]);
    }
    work_.segment<6>(6 * j) = result;
    x.segment<6>(6 * order_[index(j)]) = result;
  }
}

}  // namespace dda
