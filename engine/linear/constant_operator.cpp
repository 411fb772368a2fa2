#include "engine/linear/constant_operator.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/linear/block_vectors.h"
#include "engine/linear/different_blocks.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// 14 MB. Measured on random blocks, with a third cache of 32 MB: with 50,000 different ones rows take nine tenths of
// the time that the lower triangle takes, with 89,000 twice as long (README.md).
constexpr std::size_t blocks_in_cache = 50'000;

// What a row is summed up in: columns two by two, in three times four numbers. All lanes of them are independent, so a
// processor that adds four numbers at a time gets the same bits as one that adds two.
using Lanes = double __attribute__((vector_size(32)));

using UnalignedLanes = double __attribute__((vector_size(32), aligned(8), may_alias));

struct RowSum {
  Lanes first{}, middle{}, last{};

  [[gnu::always_inline]] inline void add(const double* block, const double* x) {
#pragma GCC unroll 3
    for (int pair = 0; pair < 3; ++pair, block += 12, x += 2) {
      const auto& b = *reinterpret_cast<const UnalignedLanes*>(block);
      const auto& c = *reinterpret_cast<const UnalignedLanes*>(block + 4);
      const auto& d = *reinterpret_cast<const UnalignedLanes*>(block + 8);
      first += b * x[0];
      middle += c * Lanes{x[0], x[0], x[1], x[1]};
      last += d * x[1];
    }
  }
  [[gnu::always_inline]] inline void store(double* y) const {
    y[0] = first[0] + middle[2], y[1] = first[1] + middle[3];
    y[2] = first[2] + last[0], y[3] = first[3] + last[1];
    y[4] = middle[0] + last[2], y[5] = middle[1] + last[3];
  }
};

struct Rows {
  const int* starts;
  const ConstantOperator::Entry* entries;
  const Mat6* blocks;

  [[gnu::always_inline]] inline void multiply(std::size_t first, std::size_t last, const double* x, double* y) const {
    for (std::size_t row = first; row < last; ++row) {
      RowSum sum;
      for (int k = starts[row]; k < starts[row + 1]; ++k)
        sum.add(blocks[entries[k].block].data(), x + static_cast<std::ptrdiff_t>(6) * entries[k].column);
      sum.store(y + 6 * row);
    }
  }
};

using MultiplyRows = void (*)(const Rows&, std::size_t, std::size_t, const double*, double*);

void multiply_two_at_a_time(const Rows& rows, std::size_t first, std::size_t last, const double* x, double* y) {
  rows.multiply(first, last, x, y);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void multiply_four_at_a_time(const Rows& rows, std::size_t first, std::size_t last,
                                                     const double* x, double* y) {
  rows.multiply(first, last, x, y);
}
MultiplyRows quickest() { return __builtin_cpu_supports("avx2") ? &multiply_four_at_a_time : &multiply_two_at_a_time; }
#else
MultiplyRows quickest() { return &multiply_two_at_a_time; }
#endif

}  // namespace

ConstantOperator::ConstantOperator(const BlockMatrix& matrix)
    : matrix_(&matrix), couplings_(matrix.couplings()), row_starts_(at(matrix.size()) + 1, 0) {
  lay_out_rows();
  take_blocks();
}

ConstantOperator::ConstantOperator(BlockMatrix&& matrix) : ConstantOperator(std::as_const(matrix)) {
  matrix_ = nullptr;
  if (has_rows()) {
    const BlockMatrix done = std::move(matrix);  // its memory is for what comes next
  } else {
    matrix_ = &own_.emplace(std::move(matrix));
  }
}

ConstantOperator::ConstantOperator(const std::vector<int>& which, std::vector<Mat6> blocks)
    : row_starts_(which.size() + 1), blocks_(std::move(blocks)) {
  std::iota(row_starts_.begin(), row_starts_.end(), 0);
  entries_.reserve(which.size());
  for (const int block : which) entries_.push_back({static_cast<int>(entries_.size()), block});
}

// Entries say where in the matrix their blocks are: k, or -k - 1 for the transpose of k.
void ConstantOperator::lay_out_rows() {
  const auto for_each_place = [this](const auto& put) {
    for (int column = 0; column < matrix_->size(); ++column)
      for (int k = matrix_->column_starts()[at(column)]; k < matrix_->column_starts()[at(column) + 1]; ++k) {
        const int row = matrix_->block_rows()[at(k)];
        put(row, column, k);
        if (row != column) put(column, row, -k - 1);
      }
  };
  for_each_place([this](int row, int, int) { ++row_starts_[at(row) + 1]; });
  std::partial_sum(row_starts_.begin(), row_starts_.end(), row_starts_.begin());
  entries_.resize(at(row_starts_.back()));
  std::vector<int> next = row_starts_;
  for_each_place([&](int row, int column, int place) { entries_[at(next[at(row)]++)] = {column, place}; });
}

// In the order of the rows, in which a product reads them.
void ConstantOperator::take_blocks() {
  DifferentBlocks numbers(blocks_);
  for (Entry& entry : entries_) {
    entry.block = entry.block >= 0 ? numbers.number_of(matrix_->offdiagonal(entry.block))
                                   : numbers.number_of(matrix_->offdiagonal(-entry.block - 1).transpose());
    if (blocks_.size() <= blocks_in_cache) continue;
    blocks_ = {};
    entries_ = {};
    return;
  }
  blocks_.shrink_to_fit();
}

Mat6 ConstantOperator::block(int i, int j) const {
  if (!has_rows()) {
    if (i == j) return matrix_->diagonal(i);
    const int slot = matrix_->slot(std::max(i, j), std::min(i, j));
    if (slot < 0) return Mat6::Zero();
    return i > j ? Mat6(matrix_->offdiagonal(slot)) : Mat6(matrix_->offdiagonal(slot).transpose());
  }
  const auto first = entries_.begin() + row_starts_[at(i)], last = entries_.begin() + row_starts_[at(i) + 1];
  const auto found = std::ranges::lower_bound(first, last, j, {}, &Entry::column);
  return found != last && found->column == j ? blocks_[at(found->block)] : Mat6::Zero();
}

BlockMatrix ConstantOperator::pattern() const {
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(at(couplings_));
  for_each_block([&](int row, int column, const auto&) {
    if (row != column) pairs.emplace_back(column, row);
  });
  BlockMatrix pattern(size(), std::move(pairs));
  pattern.forget_values();
  return pattern;
}

BlockMatrix ConstantOperator::matrix(double factor) const {
  BlockMatrix matrix = pattern();
  matrix.set_zero();
  for_each_block([&](int row, int column, const auto& block) {
    if (row == column) {
      matrix.diagonal(row) = factor * block;
    } else {
      matrix.offdiagonal(matrix.slot(row, column)) = factor * block;
    }
  });
  return matrix;
}

void ConstantOperator::multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& y, Phase phase) const {
  if (!has_rows()) {
    matrix_->multiply(x, y);
    return;
  }
  const PhaseScope scope(phase);
  static const MultiplyRows multiply_rows = quickest();
  const Rows rows{row_starts_.data(), entries_.data(), blocks_.data()};
  parallel_for(row_starts_.size() - 1, blocks_worth_sharing,
               [&](std::size_t first, std::size_t last) { multiply_rows(rows, first, last, x.data(), y.data()); });
}

}  // namespace dda
