#include "engine/cutting/quadrants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/cutting/pixel_region.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr std::size_t small_crowd = 12;     // pieces: comparing all is cheaper than dividing
constexpr std::size_t small_meeting = 128;  // pieces times nodes
// Lines that lie on each other, or that all pass one point, are not told apart by dividing.
constexpr double hardly_less = 0.85;
constexpr int most_fruitless = 4;
// Pieces that run side by side are parted along their way where most of them go that way, and few lie on both sides of
// the line that parts them.
constexpr double most_of_them = 0.6;
constexpr double hardly_more = 1.2;

// Nothing on the grid, whose coordinates stay below 2^40, lies farther from anything than this; a reach that goes
// beyond would leave the integers.
constexpr double whole_grid = 0x1p42;  // pixels

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Whether it passes within some steps of the square: separating axes, with a pixel to spare, which is far more than the
// round-off.
bool comes_near(const Quadrant& quadrant, const PixelSegment& segment, double within) {
  const double half = static_cast<double>(quadrant.size) / 2 + 1;
  const double x = static_cast<double>(segment.from.x - quadrant.lower.x) - half;
  const double y = static_cast<double>(segment.from.y - quadrant.lower.y) - half;
  const double dx = static_cast<double>(segment.to.x - segment.from.x);
  const double dy = static_cast<double>(segment.to.y - segment.from.y);
  const double reach = half + 1 + within;
  if (std::min(x, x + dx) > reach || std::max(x, x + dx) < -reach) return false;
  if (std::min(y, y + dy) > reach || std::max(y, y + dy) < -reach) return false;
  return std::abs(x * dy - y * dx) <= reach * (std::abs(dx) + std::abs(dy));
}

// A square of a power of two pixels around all pieces and what is within `margin` of them.
Quadrant root_of(const std::vector<Piece>& pieces, std::int64_t margin) {
  Pixel lower = pieces.front().segment.from;
  Pixel upper = lower;
  for (const Piece& piece : pieces) {
    for (const Pixel& end : {piece.segment.from, piece.segment.to}) {
      lower = {std::min(lower.x, end.x), std::min(lower.y, end.y)};
      upper = {std::max(upper.x, end.x), std::max(upper.y, end.y)};
    }
  }
  lower = {lower.x - margin, lower.y - margin};
  upper = {upper.x + margin, upper.y + margin};
  Quadrant root{lower, 1};
  while (root.size <= std::max(upper.x - lower.x, upper.y - lower.y)) root.size *= 2;
  return root;
}

std::array<Quadrant, 4> parts_of(const Quadrant& whole) {
  const std::int64_t half = whole.size / 2;
  const auto [x, y] = whole.lower;
  return {Quadrant{{x, y}, half}, {{x + half, y}, half}, {{x, y + half}, half}, {{x + half, y + half}, half}};
}

// Which of the four parts holds a pixel of the whole.
std::size_t part_that_holds(const Quadrant& whole, const Pixel& pixel) {
  const std::int64_t half = whole.size / 2;
  return (pixel.x >= whole.lower.x + half ? 1U : 0U) + (pixel.y >= whole.lower.y + half ? 2U : 0U);
}

// The direction of a piece with its angle doubled: opposite ways are the same.
Vec2 doubled_way(const PixelSegment& segment) {
  const Vec2 way(static_cast<double>(segment.to.x - segment.from.x),
                 static_cast<double>(segment.to.y - segment.from.y));
  const double squared = way.squaredNorm();
  return squared > 0 ? Vec2(way.x() * way.x() - way.y() * way.y(), 2 * way.x() * way.y()) / squared : Vec2(0, 0);
}

// Where a piece lies across a way.
struct Offset {
  double least = 0, most = 0;  // pixels
  std::size_t number = 0;      // in its crowd
};

Offset offset_of(const PixelSegment& segment, const Vec2& along, std::size_t number) {
  const auto across = [&](const Pixel& pixel) {
    return cross(along, Vec2(static_cast<double>(pixel.x), static_cast<double>(pixel.y)));
  };
  const auto [least, most] = std::minmax({across(segment.from), across(segment.to)});
  return {least - 1, most + 1, number};  // a pixel to spare, which is far more than the round-off
}

using PieceCrowd = std::vector<NearPiece>;

std::array<PieceCrowd, 4> parts_of(const std::array<Quadrant, 4>& parts, std::span<const NearPiece> crowd,
                                   double within) {
  std::array<PieceCrowd, 4> crowds;
  for (PieceCrowd& each : crowds) each.reserve(crowd.size() / 2);
  for (const NearPiece& piece : crowd) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (comes_near(parts[i], piece.segment, within)) crowds[i].push_back(piece);
    }
  }
  return crowds;
}

class Crowds {
 public:
  Crowds(std::size_t part, const VisitCrowd& visit) : part_(part), visit_(visit) {}

  void divide(const Quadrant& quadrant, std::span<const NearPiece> crowd, int fruitless) const {
    if (crowd.size() < 2) return;
    if (crowd.size() <= small_crowd || quadrant.size == 1 || fruitless == most_fruitless) {
      visit_(part_, quadrant, crowd);
      return;
    }
    if (divide_along(quadrant, crowd)) return;
    const std::array<Quadrant, 4> parts = parts_of(quadrant);
    std::array<PieceCrowd, 4> crowds = parts_of(parts, crowd, 0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool in_vain = static_cast<double>(crowds[i].size()) > hardly_less * static_cast<double>(crowd.size());
      divide(parts[i], crowds[i], in_vain ? fruitless + 1 : 0);
      crowds[i] = {};
    }
  }

 private:
  // Where the pieces run side by side. False, with nothing done, where a line along them does not part them.
  [[nodiscard]] bool divide_along(const Quadrant& quadrant, std::span<const NearPiece> crowd) const {
    const auto along = common_way(crowd);
    if (!along) return false;
    const auto [left, right] = sides(crowd, *along);
    const auto count = static_cast<double>(crowd.size());
    if (static_cast<double>(std::max(left.size(), right.size())) > hardly_less * count) return false;
    if (static_cast<double>(left.size() + right.size()) > hardly_more * count) return false;
    divide(quadrant, left, 0);
    divide(quadrant, right, 0);
    return true;
  }

  // Unit; nothing where the pieces run all ways.
  [[nodiscard]] static std::optional<Vec2> common_way(std::span<const NearPiece> crowd) {
    Vec2 sum = Vec2::Zero();
    for (const NearPiece& piece : crowd) sum += doubled_way(piece.segment);
    if (sum.norm() < most_of_them * static_cast<double>(crowd.size())) return std::nullopt;
    const double angle = std::atan2(sum.y(), sum.x()) / 2;
    return Vec2(std::cos(angle), std::sin(angle));
  }

  // What lies right and left of a line along them through the middle of the crowd; what it cuts is in both.
  [[nodiscard]] static std::pair<PieceCrowd, PieceCrowd> sides(std::span<const NearPiece> crowd, const Vec2& along) {
    std::vector<Offset> offsets;
    offsets.reserve(crowd.size());
    for (std::size_t i = 0; i < crowd.size(); ++i) offsets.push_back(offset_of(crowd[i].segment, along, i));
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::ranges::nth_element(offsets, middle, {}, &Offset::least);
    const double line = middle->least;
    std::pair<PieceCrowd, PieceCrowd> parts;
    for (const Offset& each : offsets) {
      if (each.least <= line) parts.first.push_back(crowd[each.number]);
      if (each.most > line) parts.second.push_back(crowd[each.number]);
    }
    return parts;
  }

  std::size_t part_;
  const VisitCrowd& visit_;
};

class Meetings {
 public:
  Meetings(std::size_t part, double reach, const VisitMeeting& visit) : part_(part), reach_(reach), visit_(visit) {}

  void divide(const Quadrant& quadrant, std::span<const NearPiece> crowd, std::span<const NearNode> nodes) const {
    if (crowd.empty() || nodes.empty()) return;
    const bool in_one_place = static_cast<double>(quadrant.size) <= std::max(reach_, 1.0);  // all near to all
    if (in_one_place || crowd.size() * nodes.size() <= small_meeting || nodes.size() == 1) {
      visit_(part_, crowd, nodes);
      return;
    }
    const std::array<Quadrant, 4> parts = parts_of(quadrant);
    std::array<std::vector<NearNode>, 4> part_nodes;
    for (const NearNode& node : nodes) part_nodes[part_that_holds(quadrant, node.pixel)].push_back(node);
    const std::array<PieceCrowd, 4> crowds = parts_of(parts, crowd, reach_);
    for (std::size_t i = 0; i < parts.size(); ++i) divide(parts[i], crowds[i], part_nodes[i]);
  }

 private:
  std::size_t part_;
  double reach_;
  const VisitMeeting& visit_;
};

// Lists of numbers, one after the other.
struct Lists {
  std::vector<std::size_t> starts;
  std::vector<int> numbers;

  [[nodiscard]] std::span<const int> operator[](std::size_t i) const {
    return std::span(numbers).subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

// The squares that threads share: a checkerboard as fine as leaves most pieces in one or two of its squares. A set of
// joints right through the plane has to stay in one, to be parted along its way.
class Board {
 public:
  Board(const std::vector<Piece>& pieces, double reach)
      : pieces_(pieces), reach_(reach), root_(root_of(pieces, static_cast<std::int64_t>(std::ceil(reach)))) {
    constexpr std::size_t worth_sharing = 10'000;  // pieces
    constexpr std::size_t most_squares_a_piece = 3;
    exponent_ = pieces.size() < worth_sharing || root_.size < (1 << most_exponent) ? 0 : most_exponent;
    while (exponent_ > 0 && !lists(most_squares_a_piece * pieces.size())) --exponent_;
    if (exponent_ == 0) lists(pieces.size());
  }

  [[nodiscard]] std::size_t squares() const { return std::size_t{1} << (2 * exponent_); }
  [[nodiscard]] Quadrant square(std::size_t i) const {
    const std::int64_t size = root_.size >> exponent_;
    const auto number = static_cast<std::int64_t>(i);
    const std::int64_t row = number >> exponent_, column = number - (row << exponent_);
    return {{root_.lower.x + column * size, root_.lower.y + row * size}, size};
  }
  // -1 outside.
  [[nodiscard]] std::int64_t square_of(const Pixel& pixel) const {
    if (!root_.holds(pixel)) return -1;
    const std::int64_t size = root_.size >> exponent_;
    return (((pixel.y - root_.lower.y) / size) << exponent_) + (pixel.x - root_.lower.x) / size;
  }
  [[nodiscard]] PieceCrowd crowd(std::size_t i) const {
    PieceCrowd crowd;
    crowd.reserve(lists_[i].size());
    for (const int piece : lists_[i]) crowd.push_back({pieces_[at(piece)].segment, piece});
    return crowd;
  }

 private:
  static constexpr int most_exponent = 4;
  static_assert(most_parts_of_plane == std::size_t{1} << (2 * most_exponent));

  template <typename Visit>
  void visit_squares(const PixelSegment& segment, const Visit& visit) const {
    const std::int64_t size = root_.size >> exponent_, last = (std::int64_t{1} << exponent_) - 1;
    const auto spare = static_cast<std::int64_t>(reach_) + 4;
    const PixelBox box = box_of(segment);
    const auto index = [&](std::int64_t way) { return std::clamp(way / size, std::int64_t{0}, last); };
    const std::int64_t left = index(box.lower.x - spare - root_.lower.x),
                       right = index(box.upper.x + spare - root_.lower.x);
    const std::int64_t low = index(box.lower.y - spare - root_.lower.y),
                       high = index(box.upper.y + spare - root_.lower.y);
    for (std::int64_t row = low; row <= high; ++row) {
      for (std::int64_t column = left; column <= right; ++column) {
        const auto i = static_cast<std::size_t>((row << exponent_) + column);
        if ((left == right && low == high) || comes_near(square(i), segment, reach_)) visit(i);
      }
    }
  }

  // False where there would be more than that in all.
  bool lists(std::size_t most) {
    std::vector<std::size_t>& starts = lists_.starts;
    starts.assign(squares() + 1, 0);
    for (const Piece& piece : pieces_) visit_squares(piece.segment, [&](std::size_t i) { ++starts[i + 1]; });
    for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
    if (starts.back() > most) return false;
    lists_.numbers.resize(starts.back());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece)
      visit_squares(pieces_[piece].segment,
                    [&](std::size_t i) { lists_.numbers[next[i]++] = static_cast<int>(piece); });
    return true;
  }

  const std::vector<Piece>& pieces_;
  double reach_;
  Quadrant root_;
  int exponent_ = 0;  // 2^exponent_ squares a side
  Lists lists_;
};

// By square of the board; a node outside of it has no piece near.
std::vector<std::vector<NearNode>> nodes_by_square(const Board& board, const std::vector<Pixel>& nodes) {
  std::vector<std::vector<NearNode>> squares(board.squares());
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const std::int64_t square = board.square_of(nodes[node]);
    if (square >= 0) squares[static_cast<std::size_t>(square)].push_back({nodes[node], static_cast<int>(node)});
  }
  return squares;
}

}  // namespace

void visit_crowds(const std::vector<Piece>& pieces, const VisitCrowd& visit) {
  if (pieces.empty()) return;
  const Board board(pieces, 0);
  parallel_for_each(board.squares(), 1,
                    [&](std::size_t part) { Crowds(part, visit).divide(board.square(part), board.crowd(part), 0); });
}

void visit_meetings(const std::vector<Piece>& pieces, const std::vector<Pixel>& nodes, double reach,
                    const VisitMeeting& visit) {
  if (pieces.empty()) return;
  const double within = std::min(reach, whole_grid);
  const Board board(pieces, within);
  const std::vector<std::vector<NearNode>> by_square = nodes_by_square(board, nodes);
  parallel_for_each(board.squares(), 1, [&](std::size_t part) {
    Meetings(part, within, visit).divide(board.square(part), board.crowd(part), by_square[part]);
  });
}

}  // namespace dda
