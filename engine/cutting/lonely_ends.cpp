#include "engine/cutting/lonely_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/geometry/box.h"

namespace dda {
namespace {

// How near another line counts, in tolerances: an end and the other line are both prolonged by one, and welding, whose
// rounds move places by a hundredth each, has as much room for either of them.
constexpr double near_in_tolerances = 4;
constexpr std::size_t grain = 4096;        // ends, for which starting a thread pays
constexpr std::int64_t most_in_cell = 32;  // where more lines pass, all ends stay: each is compared with few
constexpr std::int64_t most_cells = 9;     // around an end; a tolerance that needs more is no small one

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

double distance_from(const Pixel& place, const PixelSegment& segment) {
  const auto along_x = static_cast<double>(segment.to.x - segment.from.x);
  const auto along_y = static_cast<double>(segment.to.y - segment.from.y);
  const auto x = static_cast<double>(place.x - segment.from.x);
  const auto y = static_cast<double>(place.y - segment.from.y);
  const double squared = along_x * along_x + along_y * along_y;
  const double share = squared > 0 ? std::clamp((x * along_x + y * along_y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(x - share * along_x, y - share * along_y);
}

// The first piece of a straight is what was drawn, others prolong it.
bool is_prolongation(const std::vector<Piece>& pieces, std::size_t i) {
  return i > 0 && pieces[i].straight == pieces[i - 1].straight;
}

// What was drawn, in the cells of a raster with a few pieces a cell.
class Raster {
 public:
  explicit Raster(const std::vector<Piece>& pieces) : pieces_(pieces) {
    choose_cells();
    starts_.assign(at(columns_ * rows_) + 1, 0);
    visit_all([&](std::size_t cell, int) { ++starts_[cell + 1]; });
    for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    members_.resize(at(starts_.back()));
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    visit_all([&](std::size_t cell, int piece) { members_[at(next[cell]++)] = piece; });
  }

  // Whether a piece of another straight comes that near, pixels, or so many pass there that it was not looked at.
  [[nodiscard]] bool has_company(const Pixel& end, int straight, double reach) const {
    const auto steps = static_cast<std::int64_t>(std::ceil(reach));
    const std::int64_t left = column_of(end.x - steps), right = column_of(end.x + steps);
    const std::int64_t low = row_of(end.y - steps), high = row_of(end.y + steps);
    if ((right - left + 1) * (high - low + 1) > most_cells) return true;
    for (std::int64_t row = low; row <= high; ++row) {
      for (std::int64_t column = left; column <= right; ++column) {
        if (has_company(at(row * columns_ + column), end, straight, reach)) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool has_company(std::size_t cell, const Pixel& end, int straight, double reach) const {
    const int first = starts_[cell], last = starts_[cell + 1];
    if (last - first > most_in_cell) return true;
    return std::any_of(members_.begin() + first, members_.begin() + last, [&](int i) {
      const Piece& piece = pieces_[at(i)];
      return piece.straight != straight && distance_from(end, piece.segment) <= reach;
    });
  }

  // About as many cells as pieces, and larger ones where pieces are so long that each would pass many.
  void choose_cells() {
    Pixel upper = lower_ = pieces_.front().segment.from;
    double length = 0;
    for (const Piece& piece : pieces_) {
      for (const Pixel& end : {piece.segment.from, piece.segment.to}) {
        lower_ = {std::min(lower_.x, end.x), std::min(lower_.y, end.y)};
        upper = {std::max(upper.x, end.x), std::max(upper.y, end.y)};
      }
      length += std::hypot(static_cast<double>(piece.segment.to.x - piece.segment.from.x),
                           static_cast<double>(piece.segment.to.y - piece.segment.from.y));
    }
    const double wide = static_cast<double>(upper.x - lower_.x) + 1, high = static_cast<double>(upper.y - lower_.y) + 1;
    const auto count = static_cast<double>(pieces_.size());
    constexpr double cells_a_piece = 4;
    cell_ = static_cast<std::int64_t>(std::ceil(
        std::max({std::sqrt(wide * high / count), std::max(wide, high) / count, length / (cells_a_piece * count)})));
    columns_ = (upper.x - lower_.x) / cell_ + 1;
    rows_ = (upper.y - lower_.y) / cell_ + 1;
  }

  [[nodiscard]] std::int64_t column_of(std::int64_t x) const {
    return std::clamp((x - lower_.x) / cell_, std::int64_t{0}, columns_ - 1);
  }
  [[nodiscard]] std::int64_t row_of(std::int64_t y) const {
    return std::clamp((y - lower_.y) / cell_, std::int64_t{0}, rows_ - 1);
  }

  template <typename Visit>
  void visit_all(const Visit& visit) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!is_prolongation(pieces_, i)) visit_cells(pieces_[i].segment, static_cast<int>(i), visit);
    }
  }

  // Row by row, the cells from where the piece comes into the row to where it leaves it.
  template <typename Visit>
  void visit_cells(const PixelSegment& segment, int piece, const Visit& visit) const {
    Pixel low = segment.from;
    Pixel high = segment.to;
    if (low.y > high.y) std::swap(low, high);
    for (std::int64_t row = row_of(low.y); row <= row_of(high.y); ++row) {
      const Columns columns = columns_in(low, high, row);
      for (std::int64_t column = columns.first; column <= columns.last; ++column)
        visit(at(row * columns_ + column), piece);
    }
  }

  struct Columns {
    std::int64_t first, last;
  };

  // Two pixels to spare on either side, which is more than the round-off.
  [[nodiscard]] Columns columns_in(const Pixel& low, const Pixel& high, std::int64_t row) const {
    const std::int64_t left = std::min(low.x, high.x), right = std::max(low.x, high.x);
    if (low.y == high.y) return {column_of(left), column_of(right)};
    const double slope = static_cast<double>(high.x - low.x) / static_cast<double>(high.y - low.y);
    const auto x_at = [&](std::int64_t y) { return low.x + std::llround(slope * static_cast<double>(y - low.y)); };
    const std::int64_t one = x_at(std::max(low.y, lower_.y + row * cell_));
    const std::int64_t other = x_at(std::min(high.y, lower_.y + (row + 1) * cell_));
    return {column_of(std::max(left, std::min(one, other) - 2)), column_of(std::min(right, std::max(one, other) + 2))};
  }

  const std::vector<Piece>& pieces_;
  Pixel lower_;
  std::int64_t cell_ = 1;  // pixels
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<int> starts_, members_;  // by cell, row by row
};

// Where prolongations stay whatever is near them.
class KeptGround {
 public:
  KeptGround(const PixelGrid& grid, const RockPlan& plan) : grid_(grid), boundary_(bounding_box(plan.boundary)) {
    for (const PlanOpening& opening : plan.openings) {
      if (opening.left_out) openings_.push_back(bounding_box(opening.outline));
    }
  }

  // `end` and all within `margin`, m.
  [[nodiscard]] bool holds(const Pixel& end, double margin) const {
    const Vec2 place = grid_.centre_of(end);
    const Box around = expanded(Box{place, place}, margin);
    if (!overlap(around, expanded(boundary_, -2 * margin))) return true;
    return std::ranges::any_of(openings_, [&](const Box& opening) { return overlap(around, opening); });
  }

 private:
  const PixelGrid& grid_;
  Box boundary_;
  std::vector<Box> openings_;
};

}  // namespace

std::vector<bool> lonely_prolongations(const std::vector<Piece>& pieces, const PixelGrid& grid, double tolerance,
                                       const RockPlan& plan) {
  const double margin = near_in_tolerances * tolerance;
  const double reach = margin / grid.step();
  const Raster raster(pieces);
  const KeptGround kept(grid, plan);
  const auto is_lonely = [&](std::size_t i) {
    if (!is_prolongation(pieces, i)) return false;
    const Piece& piece = pieces[i];
    const std::size_t drawn = is_prolongation(pieces, i - 1) ? i - 2 : i - 1;
    const PixelSegment& line = pieces[drawn].segment;
    const double length =
        std::hypot(static_cast<double>(line.to.x - line.from.x), static_cast<double>(line.to.y - line.from.y));
    return length > reach && !kept.holds(piece.segment.from, margin) &&
           !raster.has_company(piece.segment.from, piece.straight, reach);
  };
  std::vector<char> found(pieces.size());
  parallel_for_each(pieces.size(), grain, [&](std::size_t i) { found[i] = is_lonely(i) ? 1 : 0; });
  return {found.begin(), found.end()};
}

}  // namespace dda
