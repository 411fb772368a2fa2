#include "engine/linear/incomplete_cholesky.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/core/phase_clock.h"
#include "engine/core/tiny_is_zero.h"
#include "engine/linear/block_order.h"
#include "engine/linear/block_vectors.h"
#include "engine/linear/small_inverse.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Fill {
  int column;
  int level;
};

void set_zero(SingleBlock& block) { block.set_zero(); }

bool invert(const Mat6& block, SingleBlock& inverse) {
  Mat6 exact;
  if (!invert_block(block, exact)) return false;
  inverse.assign(exact);
  return true;
}

// Row `row` of the pattern of M: that of A in `levels` (level 0, by column, ascending) grows by what the columns
// before it fill in. `columns` holds for each column the rows found so far, with their levels.
void fill_row(int most, const std::vector<std::vector<Fill>>& columns, std::vector<Fill>& levels) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const Fill through = levels[k];
    for (const auto& [middle, level] : columns[at(through.column)]) {  // `middle` rows between the column and the row
      const int filled = through.level + level + 1;
      if (filled > most) continue;
      const auto place = std::lower_bound(levels.begin(), levels.end(), middle,
                                          [](const Fill& fill, int column) { return fill.column < column; });
      if (place != levels.end() && place->column == middle) {
        place->level = std::min(place->level, filled);
      } else {
        levels.insert(place, {middle, filled});
      }
    }
  }
}

}  // namespace

void IncompleteCholesky::analyze(const BlockMatrix& matrix, int level) {
  order_ = cuthill_mckee_order(matrix);
  halves_ = level != diagonal && order_.size() >= worth_halving ? cut_in_halves(matrix, order_) : Halves{};
  position_.resize(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) position_[at(order_[k])] = static_cast<int>(k);
  places_.reserve(order_.size());
  is_factored_.resize(order_.size());
  lay_out(matrix, level);
  find_sources(matrix);
  find_targets();
  const std::size_t places_after = halves_.second > 0 ? order_.size() - halves_.second : 0;
  first_entry_after_ = column_starts_[order_.size() - places_after];
  blocks_.resize(2 * rows_.size() - at(first_entry_after_));
  diagonal_.resize(order_.size() + places_after);
  work_.resize(order_.size() + places_after);
  products_.resize(order_.size());
}

void IncompleteCholesky::lay_out(const BlockMatrix& matrix, int level) {
  const std::size_t n = order_.size();
  std::vector<std::vector<Fill>> rows(n);
  for (int j = 0; j < (level == diagonal ? 0 : matrix.size()); ++j) {
    for (int k = matrix.column_starts()[at(j)] + 1; k < matrix.column_starts()[at(j) + 1]; ++k) {
      const auto [low, high] = std::minmax(position_[at(matrix.block_rows()[at(k)])], position_[at(j)]);
      rows[at(high)].push_back({low, 0});
    }
  }
  std::vector<std::vector<Fill>> columns(n);  // .column holds the row
  for (std::size_t row = 0; row < n; ++row) {
    std::sort(rows[row].begin(), rows[row].end(), [](const Fill& a, const Fill& b) { return a.column < b.column; });
    fill_row(level, columns, rows[row]);
    for (const Fill& each : rows[row]) columns[at(each.column)].push_back({static_cast<int>(row), each.level});
  }
  column_starts_ = {0};
  rows_.clear();
  for (const auto& column : columns) {
    for (const Fill& each : column) rows_.push_back(each.column);
    column_starts_.push_back(static_cast<int>(rows_.size()));
  }
}

int IncompleteCholesky::entry(int row, int column) const {
  const auto first = rows_.begin() + column_starts_[at(column)];
  const auto last = rows_.begin() + column_starts_[at(column) + 1];
  const auto found = std::lower_bound(first, last, row);
  return found != last && *found == row ? static_cast<int>(found - rows_.begin()) : -1;
}

void IncompleteCholesky::find_sources(const BlockMatrix& matrix) {
  sources_.clear();
  is_fill_.assign(rows_.size(), 1);
  for (int j = 0; j < (rows_.empty() ? 0 : matrix.size()); ++j) {
    for (int k = matrix.column_starts()[at(j)] + 1; k < matrix.column_starts()[at(j) + 1]; ++k) {
      const int row = position_[at(matrix.block_rows()[at(k)])];
      const int column = position_[at(j)];
      sources_.push_back({entry(std::max(row, column), std::min(row, column)), row < column});
      is_fill_[at(sources_.back().entry)] = 0;
    }
  }
}

void IncompleteCholesky::find_targets() {
  targets_.clear();
  target_starts_.assign(1, 0);
  for (std::size_t column = 0; column < order_.size(); ++column) {
    const int first = column_starts_[column];
    const int last = column_starts_[column + 1];
    for (int i = first; i < last; ++i)
      for (int j = first; j < i; ++j) targets_.push_back(entry(rows_[at(i)], rows_[at(j)]));
    target_starts_.push_back(static_cast<int>(targets_.size()));
  }
}

bool IncompleteCholesky::factorize(const BlockMatrix& matrix) {
  places_.resize(order_.size());
  std::iota(places_.begin(), places_.end(), 0);
  std::fill(is_factored_.begin(), is_factored_.end(), 1);
  return factorize_places(matrix);
}

bool IncompleteCholesky::factorize(const BlockMatrix& matrix, const BlockPart& part) {
  places_.clear();
  for (std::size_t k = 0; k < order_.size(); ++k) {
    is_factored_[k] = part.contains(order_[k]) ? 1 : 0;
    if (is_factored_[k] != 0) places_.push_back(static_cast<int>(k));
  }
  return factorize_places(matrix);
}

bool IncompleteCholesky::factorize_places(const BlockMatrix& matrix) {
  for (const double shift : {0.0, 1e-2, 1e-1}) {
    shift_ = shift;
    load(matrix, shift);
    if (eliminate_all()) return true;
    if (rows_.empty()) return false;
  }
  return take_diagonal_only(matrix);
}

template <typename Act>
void IncompleteCholesky::for_each_place(const Act& act) const {
  parallel_for_each(places_.size(), blocks_worth_sharing, [&](std::size_t k) { act(places_[k]); });
}

template <bool apart>
std::size_t IncompleteCholesky::entry_for(int entry) const {
  const bool is_kept_apart = apart && entry >= first_entry_after_;
  return is_kept_apart ? at(entry - first_entry_after_) + rows_.size() : at(entry);
}

template <bool apart>
std::size_t IncompleteCholesky::place_for(int place) const {
  const bool is_kept_apart = apart && at(place) >= halves_.second;
  return is_kept_apart ? at(place) - halves_.second + order_.size() : at(place);
}

void IncompleteCholesky::clear_fill(int column) {
  for (int k = column_starts_[at(column)]; k < column_starts_[at(column) + 1]; ++k)
    if (is_fill_[at(k)] != 0) blocks_[at(k)].set_zero();
}

// Single precision reaches from 1e-38 to 1e38: the matrix is brought to 1, whatever its units.
void IncompleteCholesky::load(const BlockMatrix& matrix, double shift) {
  double largest = 0;
  for (const int k : places_) largest = std::max(largest, matrix.diagonal(order_[at(k)]).diagonal().maxCoeff());
  scale_ = 1 / largest;
  for_each_place([&](int k) {
    clear_fill(k);
    Mat6 own = scale_ * matrix.diagonal(order_[at(k)]);
    own.diagonal() *= 1 + shift;
    diagonal_[at(k)].assign(own);
  });
  if (!rows_.empty()) for_each_place([&](int k) { load_column(matrix, order_[at(k)]); });
}

void IncompleteCholesky::load_column(const BlockMatrix& matrix, int block) {
  const int first = matrix.column_starts()[at(block)] + 1;
  for (int k = first; k < matrix.column_starts()[at(block) + 1]; ++k) {
    if (is_factored_[at(position_[at(matrix.block_rows()[at(k)])])] == 0) continue;
    const Source& source = sources_[at(k - block - 1)];  // block + 1 diagonal blocks have gone before
    if (source.transposed) {
      blocks_[at(source.entry)].assign(scale_ * matrix.offdiagonal(k).transpose());
    } else {
      blocks_[at(source.entry)].assign(scale_ * matrix.offdiagonal(k));
    }
  }
}

bool IncompleteCholesky::eliminate_all() {
  return is_halved() ? eliminate_halves() : eliminate_between<false>(0, places_.size());
}

bool IncompleteCholesky::eliminate_halves() {
  std::for_each(blocks_.begin() + static_cast<std::ptrdiff_t>(rows_.size()), blocks_.end(), set_zero);
  std::for_each(diagonal_.begin() + static_cast<std::ptrdiff_t>(order_.size()), diagonal_.end(), set_zero);
  std::array<bool, 2> done{};
  for_each_piece({2, 2}, [&](std::size_t half, std::size_t, std::size_t) {
    done[half] =
        half == 0 ? eliminate_between<false>(0, halves_.first) : eliminate_between<true>(halves_.first, halves_.second);
  });
  if (!done[0] || !done[1]) return false;
  for (std::size_t i = rows_.size(); i < blocks_.size(); ++i)
    blocks_[i - rows_.size() + at(first_entry_after_)] += blocks_[i];
  for (std::size_t i = order_.size(); i < diagonal_.size(); ++i)
    diagonal_[i - order_.size() + halves_.second] += diagonal_[i];
  return eliminate_between<false>(halves_.second, order_.size());
}

// `apart`: what comes off columns after the halves is kept apart.
template <bool apart>
bool IncompleteCholesky::eliminate_between(std::size_t first, std::size_t last) {
  for (std::size_t place = first; place < last; ++place) {
    const int column = places_[place];
    if (!invert(diagonal_[at(column)].to_double(), diagonal_[at(column)])) return false;
    eliminate<apart>(column);
  }
  return true;
}

bool IncompleteCholesky::take_diagonal_only(const BlockMatrix& matrix) {
  shift_ = 0;
  for (const int k : places_) {
    for (int entry = column_starts_[at(k)]; entry < column_starts_[at(k) + 1]; ++entry) blocks_[at(entry)].set_zero();
    if (!invert(scale_ * matrix.diagonal(order_[at(k)]), diagonal_[at(k)])) return false;
  }
  return true;
}

// Takes what the column at hand adds off the columns after it: A_ij -= M_ik D_k M_jk^T.
template <bool apart>
void IncompleteCholesky::eliminate(int column) {
  const int first = column_starts_[at(column)];
  const int count = column_starts_[at(column) + 1] - first;
  const int* target = targets_.data() + target_starts_[at(column)];
  for (int i = 0; i < count; target += i, ++i) {
    if (is_factored_[at(rows_[at(first + i)])] == 0) continue;
    SingleBlock& block = blocks_[at(first + i)];
    const DoubledColumns unscaled(block);
    block.set_zero();
    add_product_transposed<1>(unscaled, diagonal_[at(column)], block);  // D^-1 is symmetric
    for (int j = 0; j < i; ++j)
      if (target[j] >= 0 && is_factored_[at(rows_[at(first + j)])] != 0)
        add_product_transposed<-1>(unscaled, blocks_[at(first + j)], blocks_[entry_for<apart>(target[j])]);
    add_product_transposed<-1>(unscaled, block, diagonal_[place_for<apart>(rows_[at(first + i)])]);
  }
}

double IncompleteCholesky::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  const PhaseScope scope(Phase::preconditioner);
  if (!is_whole()) z.setZero();
  double largest = largest_entry(r);
  if (largest < std::numeric_limits<double>::min()) largest = 1;
  return is_whole() && rows_.empty() ? apply_diagonal(largest, r, z) : substitute(largest, r, z);
}

double IncompleteCholesky::largest_entry(const Eigen::VectorXd& r) const {
  const auto larger = [](double one, double other) { return std::max(one, other); };
  if (is_whole())
    return parallel_reduce(places_.size(), blocks_of_plain_sum, larger, [&r](std::size_t first, std::size_t last) {
      return VectorStretch(first, last).of(r).cwiseAbs().maxCoeff();
    });
  double largest = 0;
  for (const int j : places_) largest = larger(largest, r.segment<6>(6 * order_[at(j)]).cwiseAbs().maxCoeff());
  return largest;
}

// Without couplings every block is by itself. Summed from the last to the first, as substitute() does.
double IncompleteCholesky::apply_diagonal(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  const double shrink = 1 / unit;
  parallel_for(order_.size(), blocks_worth_sharing, [&](std::size_t first, std::size_t last) {
    const TinyIsZero on_this_thread;
    for (std::size_t place = first; place < last; ++place) {
      const auto own = r.segment<6>(6 * order_[place]);
      auto result = z.segment<6>(6 * order_[place]);
      result = (scale_ * unit) * ColumnFactors(SingleSix(shrink * own)).times(diagonal_[place]).to_double();
      products_[place] = result.dot(own);
    }
  });
  return parallel_sum(order_.size(), blocks_of_plain_sum, [this](std::size_t first, std::size_t last) {
    return std::accumulate(products_.rend() - static_cast<std::ptrdiff_t>(last),
                           products_.rend() - static_cast<std::ptrdiff_t>(first), 0.0);
  });
}

// `unit`: what counts as 1 in r.
double IncompleteCholesky::substitute(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  const double shrink = 1 / unit;
  for_each_place([&](int j) { work_[at(j)] = SingleSix(shrink * r.segment<6>(6 * order_[at(j)])); });
  if (is_halved()) return substitute_halves(unit, r, z);
  if (is_whole()) {
    forward<true, false>(0, places_.size());
    return backward<true>(unit, 0, places_.size(), r, z);
  }
  forward<false, false>(0, places_.size());
  return backward<false>(unit, 0, places_.size(), r, z);
}

double IncompleteCholesky::substitute_halves(double unit, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  std::fill(work_.begin() + static_cast<std::ptrdiff_t>(order_.size()), work_.end(), SingleSix());
  for_each_piece({2, 2}, [&](std::size_t half, std::size_t, std::size_t) {
    half == 0 ? forward<true, false>(0, halves_.first) : forward<true, true>(halves_.first, halves_.second);
  });
  for (std::size_t i = order_.size(); i < work_.size(); ++i) work_[i - order_.size() + halves_.second] += work_[i];
  forward<true, false>(halves_.second, order_.size());
  double product = backward<true>(unit, halves_.second, order_.size(), r, z);
  std::array<double, 2> products{};
  for_each_piece({2, 2}, [&](std::size_t half, std::size_t, std::size_t) {
    products[half] = half == 0 ? backward<true>(unit, 0, halves_.first, r, z)
                               : backward<true>(unit, halves_.first, halves_.second, r, z);
  });
  return product + products[1] + products[0];
}

// Where the whole was factored the innermost loops need not ask which rows there are: half of their time.
template <bool whole, bool apart>
void IncompleteCholesky::forward(std::size_t first, std::size_t last) {
  const TinyIsZero on_this_thread;
  for (std::size_t place = first; place < last; ++place) {
    const int j = places_[place];
    const ColumnFactors known(work_[at(j)]);
    for (int k = column_starts_[at(j)]; k < column_starts_[at(j) + 1]; ++k)
      if (whole || is_factored_[at(rows_[at(k)])] != 0)
        work_[place_for<apart>(rows_[at(k)])] -= known.times(blocks_[at(k)]);
    work_[at(j)] = known.times(diagonal_[at(j)]);
  }
}

template <bool whole>
double IncompleteCholesky::backward(double unit, std::size_t first, std::size_t last, const Eigen::VectorXd& r,
                                    Eigen::VectorXd& z) {
  const TinyIsZero on_this_thread;
  double product = 0;
  for (std::size_t place = last; place-- > first;) {
    const int j = places_[place];
    TransposedSum below;
    for (int k = column_starts_[at(j)]; k < column_starts_[at(j) + 1]; ++k)
      if (whole || is_factored_[at(rows_[at(k)])] != 0) below.add(blocks_[at(k)], work_[at(rows_[at(k)])]);
    work_[at(j)] -= below.total();
    auto result = z.segment<6>(6 * order_[at(j)]);
    result = (scale_ * unit) * work_[at(j)].to_double();
    product += result.dot(r.segment<6>(6 * order_[at(j)]));
  }
  return product;
}

}  // namespace dda
