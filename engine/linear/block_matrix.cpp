#include "engine/linear/block_matrix.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "engine/core/phase_clock.h"
#include "engine/linear/block_vectors.h"

namespace dda {
namespace {

void check_couplings(int blocks, const std::vector<std::pair<int, int>>& couplings) {
  if (blocks < 0) throw std::invalid_argument("BlockMatrix: negative number of blocks");
  for (const auto& [i, j] : couplings) {
    if (std::min(i, j) < 0 || std::max(i, j) >= blocks) {
      throw std::invalid_argument("BlockMatrix: coupling (" + std::to_string(i) + ", " + std::to_string(j) +
                                  ") outside of the " + std::to_string(blocks) + " blocks");
    }
  }
}

// Each pair as (column, row) with column < row, sorted, once.
void normalize(std::vector<std::pair<int, int>>& couplings) {
  for (auto& [column, row] : couplings) {
    if (column > row) std::swap(column, row);
  }
  std::erase_if(couplings, [](const auto& pair) { return pair.first == pair.second; });
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
}

}  // namespace

BlockMatrix::BlockMatrix(int blocks, std::vector<std::pair<int, int>> couplings) {
  check_couplings(blocks, couplings);
  normalize(couplings);
  const std::size_t stored = index(blocks) + couplings.size();
  if (stored > std::size_t{std::numeric_limits<int>::max()} / 36) {
    throw std::invalid_argument("BlockMatrix: too many blocks for 32-bit indices");
  }
  build_pattern(blocks, couplings);
  build_places();
  build_shares();
  set_zero();
}

void BlockMatrix::build_pattern(int blocks, const std::vector<std::pair<int, int>>& couplings) {
  column_starts_.reserve(index(blocks) + 1);
  block_rows_.reserve(index(blocks) + couplings.size());
  auto next = couplings.begin();
  for (int column = 0; column < blocks; ++column) {
    column_starts_.push_back(static_cast<int>(block_rows_.size()));
    block_rows_.push_back(column);
    for (; next != couplings.end() && next->first == column; ++next) block_rows_.push_back(next->second);
  }
  column_starts_.push_back(static_cast<int>(block_rows_.size()));
}

void BlockMatrix::build_places() {
  places_.reserve(block_rows_.size());
  for (int column = 0; column < size(); ++column) {
    const int first = column_starts_[index(column)];
    const int last = column_starts_[index(column) + 1];
    for (int k = first; k < last; ++k) places_.push_back({36 * first + 6 * (k - first), 6 * (last - first)});
  }
}

// Where products are not worth sharing there is one share, and nothing reaches into it.
void BlockMatrix::build_shares() {
  constexpr std::size_t most = 16;
  shares_ = {index(size()), std::clamp<std::size_t>(index(size()) / blocks_worth_sharing, 1, most)};
  if (shares_.count == 1) return;
  std::vector<std::vector<Reach>> reaches(shares_.count);
  std::size_t own = 0;
  for (int column = 0; column < size(); ++column) {
    while (shares_.begin_of(own + 1) <= index(column)) ++own;
    std::size_t other = own;
    for (int k = column_starts_[index(column)]; k < column_starts_[index(column) + 1]; ++k) {
      while (shares_.begin_of(other + 1) <= index(block_rows_[index(k)])) ++other;
      if (other != own) reaches[other].push_back({column, k});
    }
  }
  reach_starts_ = {0};
  for (const auto& into_share : reaches) {
    reaches_.insert(reaches_.end(), into_share.begin(), into_share.end());
    reach_starts_.push_back(reaches_.size());
  }
}

int BlockMatrix::slot(int i, int j) const {
  if (j < 0 || i <= j || i >= size()) return -1;
  const auto first = block_rows_.begin() + column_starts_[index(j)] + 1;
  const auto last = block_rows_.begin() + column_starts_[index(j) + 1];
  const auto found = std::lower_bound(first, last, i);
  return found != last && *found == i ? static_cast<int>(found - block_rows_.begin()) : -1;
}

void BlockMatrix::add_coupling(int i, int j, const Mat6& stiffness) {
  const bool is_diagonal = i == j && i >= 0 && i < size();
  const int k = is_diagonal ? column_starts_[index(i)] : slot(std::max(i, j), std::min(i, j));
  if (k < 0) {
    throw std::out_of_range("BlockMatrix: no block (" + std::to_string(i) + ", " + std::to_string(j) + ")");
  }
  if (i < j) {
    block(k) += stiffness.transpose();
  } else {
    block(k) += stiffness;
  }
}

void BlockMatrix::set_zero() { values_.assign(36 * block_rows_.size(), 0.0); }

void BlockMatrix::set_values(const BlockMatrix& same_pattern) {
  if (same_pattern.values_.size() != values_.size())
    throw std::invalid_argument("BlockMatrix: values of a matrix of another pattern");
  std::copy(same_pattern.values_.begin(), same_pattern.values_.end(), values_.begin());
}

PanelProduct BlockMatrix::panel_product(int column, const double* x) const {
  const int first = column_starts_[index(column)];
  const int height = column_starts_[index(column) + 1] - first;
  return {values_.data() + 36 * index(first), 6 * height, x + 6 * column};
}

void BlockMatrix::multiply_share(std::size_t share, const double* x, Vector& y) const {
  const int begin = static_cast<int>(shares_.begin_of(share));
  const int end = static_cast<int>(shares_.begin_of(share + 1));
  y.segment(6 * begin, 6 * (end - begin)).setZero();
  for (std::size_t i = reach_starts_[share]; i < reach_starts_[share + 1]; ++i) {
    const auto [column, k] = reaches_[i];
    panel_product(column, x).scatter(k - column_starts_[index(column)], y.data() + 6 * block_rows_[index(k)]);
  }
  for (int column = begin; column < end; ++column) {
    PanelProduct product = panel_product(column, x);
    const int first = column_starts_[index(column)];
    int k = first + 1;
    for (; k < column_starts_[index(column) + 1] && block_rows_[index(k)] < end; ++k)
      product.couple(k - first, x + 6 * block_rows_[index(k)], y.data() + 6 * block_rows_[index(k)]);
    for (; k < column_starts_[index(column) + 1]; ++k) product.gather(k - first, x + 6 * block_rows_[index(k)]);
    product.add_to(y.data() + 6 * column);
  }
}

template <typename Meets>
void BlockMatrix::multiply_where(const Meets& meets, const double* x, Vector& y) const {
  y.setZero();
  for (int column = 0; column < size(); ++column) {
    const int first = column_starts_[index(column)];
    const int last = column_starts_[index(column) + 1];
    PanelProduct product = panel_product(column, x);
    bool met = meets(column, column);
    for (int k = first + 1; k < last; ++k) {
      const int row = block_rows_[index(k)];
      if (!meets(column, row)) continue;
      product.couple(k - first, x + 6 * row, y.data() + 6 * row);
      met = true;
    }
    if (met) product.add_to(y.data() + 6 * column);
  }
}

void BlockMatrix::multiply(const Eigen::Ref<const Vector>& x, Vector& y) const {
  const PhaseScope scope(Phase::product);
  if (shares_.count == 1 || threads_in_use() == 1) {
    multiply_where([](int, int) { return true; }, x.data(), y);
  } else {
    for_each_piece(shares_, [&](std::size_t share, std::size_t, std::size_t) { multiply_share(share, x.data(), y); });
  }
}

void BlockMatrix::multiply(const BlockPart& part, const Vector& x, Vector& y) const {
  const PhaseScope scope(Phase::product);
  multiply_where([&part](int column, int row) { return part.contains(column) || part.contains(row); }, x.data(), y);
}

}  // namespace dda
