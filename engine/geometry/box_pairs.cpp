#include "engine/geometry/box_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace dda {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

struct Cell {
  int level;
  int column;
  int row;
  bool operator==(const Cell&) const = default;
};

std::pair<int, int> pair_of(std::size_t i, std::size_t j) { return {static_cast<int>(i), static_cast<int>(j)}; }

Pairs brute_force(std::span<const Box> boxes) {
  Pairs pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (is_empty(boxes[i]) || is_empty(boxes[j])) continue;
      if (overlap(boxes[i], boxes[j])) pairs.push_back(pair_of(i, j));
    }
  }
  return pairs;
}

// Sorted by counting on the first index, quicker than a comparison sort as each has few partners.
Pairs ordered(const Pairs& pairs, std::size_t count) {
  std::vector<std::ptrdiff_t> next(count + 1, 0);  // where the next pair of each first index goes
  for (const auto& [first, second] : pairs) ++next[static_cast<std::size_t>(first) + 1];
  for (std::size_t i = 1; i <= count; ++i) next[i] += next[i - 1];
  Pairs sorted(pairs.size());
  for (const auto& pair : pairs) sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(pair.first)]++)] = pair;
  std::ptrdiff_t start = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::sort(sorted.begin() + start, sorted.begin() + next[i]);
    start = next[i];
  }
  return sorted;
}

double size_of(const Box& box) { return (box.upper - box.lower).maxCoeff(); }

// A grid for each level, cells doubling from level to level. A box belongs to a level whose cells are larger than it,
// the lowest where others lie near, and there to the one cell that holds its lower corner; so on any level the partners
// of a box start between one cell before its lower corner and its upper corner.
class GridLevels {
 public:
  enum class For { one_look, many_questions };

  GridLevels(std::span<const Box> boxes, For use) : boxes_(boxes), bucket_mask_(std::bit_ceil(boxes.size() * 2) - 1) {
    choose_scale();
    place_boxes();
    if (use == For::many_questions && has_cells()) join_levels();
    fill_buckets();
  }

  [[nodiscard]] Pairs pairs() const {
    if (!has_cells()) return brute_force(boxes_);
    Pairs found;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (is_empty(boxes_[i])) continue;
      for (int level = cells_[i].level; level < level_count; ++level) {
        if (!level_members_[static_cast<std::size_t>(level)].empty()) append_partners(i, level, found);
      }
    }
    return ordered(found, boxes_.size());
  }

  [[nodiscard]] std::vector<int> overlapping(const Box& box) const {
    std::vector<int> found;
    if (!overlap(box, bounds_)) return found;
    const Box inside{box.lower.cwiseMax(bounds_.lower), box.upper.cwiseMin(bounds_.upper)};
    const auto take = [&](std::size_t j) { found.push_back(static_cast<int>(j)); };
    for (int level = 0; level < level_count; ++level) {
      const std::vector<std::size_t>& members = level_members_[static_cast<std::size_t>(level)];
      if (members.empty()) continue;
      if (!has_cells() || cells_reached_by(inside, level) > static_cast<double>(members.size()))
        look_at_all(inside, members, take);
      else
        visit_overlapping(inside, level, take);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static constexpr int level_count = 24;
  static constexpr Cell nowhere{-1, 0, 0};         // of empty boxes
  static constexpr double slack = 1 + 1.0 / 1024;  // cells exceed boxes by more than the round-off of cell indices

  void choose_scale() {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes_) {
      if (is_empty(box)) continue;
      bounds_ = expanded(expanded(bounds_, box.lower), box.upper);
      smallest = std::min(smallest, size_of(box));
    }
    if (is_empty(bounds_)) return;
    const double extent = size_of(bounds_);
    // The highest level must hold the largest box, and cell indices stay below 2^23.
    smallest_cell_ = std::max(slack * smallest, std::ldexp(slack * extent, 1 - level_count));
    if (smallest_cell_ == 0) smallest_cell_ = 1;
  }

  // Boxes that are farther apart than the largest number have no cells: each is compared with all.
  [[nodiscard]] bool has_cells() const { return std::isfinite(size_of(bounds_)); }

  [[nodiscard]] int level_of(const Box& box) const {
    const double cells = slack * size_of(box) / smallest_cell_;
    return cells <= 1 ? 0 : static_cast<int>(std::ceil(std::log2(cells)));
  }

  [[nodiscard]] Cell cell_at(const Vec2& point, int level) const {
    if (!point.allFinite()) return {level, 0, 0};
    const Vec2 index = (point - bounds_.lower) / std::ldexp(smallest_cell_, level);
    return {level, static_cast<int>(std::floor(index.x())), static_cast<int>(std::floor(index.y()))};
  }

  [[nodiscard]] std::size_t bucket(const Cell& cell) const {
    const auto word = [](int value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    // Odd multipliers from the golden ratio and its like spread neighbouring cells over the buckets.
    std::uint64_t hash = word(cell.column) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 32) ^ word(cell.row)) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ (hash >> 29) ^ word(cell.level)) * 0x165667B19E3779F9u;
    return static_cast<std::size_t>(hash >> 32) & bucket_mask_;
  }

  void place_boxes() {
    cells_.assign(boxes_.size(), nowhere);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (is_empty(boxes_[i])) continue;
      cells_[i] = has_cells() ? cell_at(boxes_[i].lower, level_of(boxes_[i])) : Cell{0, 0, 0};
      level_members_[static_cast<std::size_t>(cells_[i].level)].push_back(i);
    }
  }

  // Lines cut at random have edges of all sizes, the smaller the fewer. Small cells for boxes that lie far apart would
  // be levels that every question has to ask in vain: where boxes lie apart in cells twice as large as well, they go
  // there.
  void join_levels() {
    for (int level = 0; level + 1 < level_count; ++level) {
      std::vector<std::size_t>& members = level_members_[static_cast<std::size_t>(level)];
      if (members.empty() || !lie_apart(members, level + 1)) continue;
      std::vector<std::size_t>& above = level_members_[static_cast<std::size_t>(level) + 1];
      for (const std::size_t i : members) cells_[i] = cell_at(boxes_[i].lower, level + 1);
      above.insert(above.end(), members.begin(), members.end());
      members.clear();
    }
  }

  // Whether boxes in cells of this level would have, in the mean over the boxes, less than one other in their cell.
  [[nodiscard]] bool lie_apart(const std::vector<std::size_t>& boxes, int level) const {
    const auto allowed = 2 * static_cast<double>(boxes.size());
    if (static_cast<double>(boxes.size()) * static_cast<double>(boxes.size()) >
        allowed * cells_reached_by(bounds_, level))
      return false;  // were they spread as evenly as can be
    std::vector<std::pair<int, int>> places;
    places.reserve(boxes.size());
    for (const std::size_t i : boxes) {
      const Cell cell = cell_at(boxes_[i].lower, level);
      places.emplace_back(cell.column, cell.row);
    }
    std::sort(places.begin(), places.end());
    double companions = 0;
    for (auto first = places.begin(); first != places.end();) {
      const auto last = std::find_if(first, places.end(), [&](const auto& place) { return place != *first; });
      companions += static_cast<double>((last - first) * (last - first));
      first = last;
    }
    return companions <= allowed;
  }

  // Counting sort of the boxes by bucket.
  void fill_buckets() {
    bucket_start_.assign(bucket_mask_ + 2, 0);
    for (const Cell& cell : cells_) ++bucket_start_[bucket(cell) + 1];
    for (std::size_t b = 1; b < bucket_start_.size(); ++b) bucket_start_[b] += bucket_start_[b - 1];
    std::vector<std::size_t> next(bucket_start_.begin(), bucket_start_.end() - 1);
    members_.assign(cells_.size(), 0);
    for (std::size_t i = 0; i < cells_.size(); ++i) members_[next[bucket(cells_[i])]++] = i;
  }

  // Calls visit(j) for the boxes of the level that overlap `box`.
  template <typename Visit>
  void visit_overlapping(const Box& box, int level, const Visit& visit) const {
    const Cell first = cell_at(box.lower, level);
    const Cell last = cell_at(box.upper, level);
    for (int column = first.column - 1; column <= last.column; ++column)
      for (int row = first.row - 1; row <= last.row; ++row) visit_overlapping(box, Cell{level, column, row}, visit);
  }

  template <typename Visit>
  void visit_overlapping(const Box& box, const Cell& cell, const Visit& visit) const {
    const std::size_t at = bucket(cell);
    for (std::size_t k = bucket_start_[at]; k < bucket_start_[at + 1]; ++k) {
      const std::size_t j = members_[k];
      if (cells_[j] == cell && overlap(box, boxes_[j])) visit(j);
    }
  }

  void append_partners(std::size_t i, int level, Pairs& found) const {
    visit_overlapping(boxes_[i], level, [&](std::size_t j) {
      if (level > cells_[i].level || j > i) found.push_back(pair_of(std::min(i, j), std::max(i, j)));
    });
  }

  // The boxes of a cell start in it, so those of one cell before the box can reach into it too. A box of ordinary size
  // reaches millions of cells of a level that is there for a few tiny boxes: these are looked at one by one.
  [[nodiscard]] double cells_reached_by(const Box& box, int level) const {
    const Vec2 across = (box.upper - box.lower) / std::ldexp(smallest_cell_, level) + Vec2::Constant(2);
    return across.x() * across.y();
  }

  template <typename Visit>
  void look_at_all(const Box& box, const std::vector<std::size_t>& members, const Visit& visit) const {
    for (const std::size_t j : members)
      if (overlap(box, boxes_[j])) visit(j);
  }

  std::span<const Box> boxes_;
  std::size_t bucket_mask_;
  Box bounds_;  // of all boxes
  double smallest_cell_ = 1;
  std::vector<Cell> cells_;
  std::vector<std::size_t> bucket_start_;  // bucket b holds members_[bucket_start_[b]] up to bucket_start_[b + 1]
  std::vector<std::size_t> members_;
  std::array<std::vector<std::size_t>, level_count> level_members_;
};

}  // namespace

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes) {
  constexpr std::size_t few = 32;  // where comparing all is quicker than building a grid
  return boxes.size() <= few ? brute_force(boxes) : GridLevels(boxes, GridLevels::For::one_look).pairs();
}

struct BoxIndex::Levels {
  explicit Levels(std::vector<Box> given) : boxes(std::move(given)), grid(boxes, GridLevels::For::many_questions) {}

  std::vector<Box> boxes;
  GridLevels grid;
};

BoxIndex::BoxIndex(std::vector<Box> boxes) : levels_(std::make_unique<const Levels>(std::move(boxes))) {}

BoxIndex::~BoxIndex() = default;

std::vector<int> BoxIndex::overlapping(const Box& box) const { return levels_->grid.overlapping(box); }

}  // namespace dda
