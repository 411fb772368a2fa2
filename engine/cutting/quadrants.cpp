#include "engine/cutting/quadrants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

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

Quadrant root_of(const std::vector<Piece>& pieces) {
  Pixel lower = pieces.front().segment.from;
  Pixel upper = lower;
  for (const Piece& piece : pieces) {
    for (const Pixel& end : {piece.segment.from, piece.segment.to}) {
      lower = {std::min(lower.x, end.x), std::min(lower.y, end.y)};
      upper = {std::max(upper.x, end.x), std::max(upper.y, end.y)};
    }
  }
  Quadrant root{lower, 1};
  while (root.size <= std::max(upper.x - lower.x, upper.y - lower.y)) root.size *= 2;
  return root;
}

std::array<Quadrant, 4> parts_of(const Quadrant& whole) {
  const std::int64_t half = whole.size / 2;
  const auto [x, y] = whole.lower;
  return {Quadrant{{x, y}, half}, {{x + half, y}, half}, {{x, y + half}, half}, {{x + half, y + half}, half}};
}

std::vector<int> all_of(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
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
  int piece = 0;
};

Offset offset_of(const PixelSegment& segment, const Vec2& along, int piece) {
  const auto across = [&](const Pixel& pixel) {
    return cross(along, Vec2(static_cast<double>(pixel.x), static_cast<double>(pixel.y)));
  };
  const auto [least, most] = std::minmax({across(segment.from), across(segment.to)});
  return {least - 1, most + 1, piece};  // a pixel to spare, which is far more than the round-off
}

class Crowds {
 public:
  Crowds(const std::vector<Piece>& pieces, const std::function<void(const Quadrant&, const std::vector<int>&)>& visit)
      : pieces_(pieces), visit_(visit) {
    ways_.reserve(pieces.size());
    for (const Piece& piece : pieces) ways_.push_back(doubled_way(piece.segment));
  }

  void divide(const Quadrant& quadrant, const std::vector<int>& crowd, int fruitless) const {
    if (crowd.size() < 2) return;
    if (crowd.size() <= small_crowd || quadrant.size == 1 || fruitless == most_fruitless) {
      visit_(quadrant, crowd);
      return;
    }
    if (divide_along(quadrant, crowd)) return;
    std::vector<int> part_crowd;
    for (const Quadrant& part : parts_of(quadrant)) {
      part_crowd.clear();
      std::copy_if(crowd.begin(), crowd.end(), std::back_inserter(part_crowd),
                   [&](int piece) { return comes_near(part, pieces_[at(piece)].segment, 0); });
      const bool in_vain = static_cast<double>(part_crowd.size()) > hardly_less * static_cast<double>(crowd.size());
      divide(part, part_crowd, in_vain ? fruitless + 1 : 0);
    }
  }

 private:
  // Where the pieces run side by side. False, with nothing done, where a line along them does not part them.
  [[nodiscard]] bool divide_along(const Quadrant& quadrant, const std::vector<int>& crowd) const {
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
  [[nodiscard]] std::optional<Vec2> common_way(const std::vector<int>& crowd) const {
    Vec2 sum = Vec2::Zero();
    for (const int piece : crowd) sum += ways_[at(piece)];
    if (sum.norm() < most_of_them * static_cast<double>(crowd.size())) return std::nullopt;
    const double angle = std::atan2(sum.y(), sum.x()) / 2;
    return Vec2(std::cos(angle), std::sin(angle));
  }

  // What lies right and left of a line along them through the middle of the crowd; what it cuts is in both.
  [[nodiscard]] std::pair<std::vector<int>, std::vector<int>> sides(const std::vector<int>& crowd,
                                                                    const Vec2& along) const {
    std::vector<Offset> offsets;
    offsets.reserve(crowd.size());
    for (const int piece : crowd) offsets.push_back(offset_of(pieces_[at(piece)].segment, along, piece));
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::ranges::nth_element(offsets, middle, {}, &Offset::least);
    const double line = middle->least;
    std::pair<std::vector<int>, std::vector<int>> parts;
    for (const Offset& each : offsets) {
      if (each.least <= line) parts.first.push_back(each.piece);
      if (each.most > line) parts.second.push_back(each.piece);
    }
    return parts;
  }

  const std::vector<Piece>& pieces_;
  const std::function<void(const Quadrant&, const std::vector<int>&)>& visit_;
  std::vector<Vec2> ways_;  // of the pieces, doubled
};

class Meetings {
 public:
  Meetings(const std::vector<Piece>& pieces, const std::vector<Pixel>& nodes, double reach,
           const std::function<void(const std::vector<int>&, const std::vector<int>&)>& visit)
      : pieces_(pieces), nodes_(nodes), reach_(reach), visit_(visit) {}

  void divide(const Quadrant& quadrant, const std::vector<int>& crowd, const std::vector<int>& nodes) const {
    if (crowd.empty() || nodes.empty()) return;
    if (crowd.size() * nodes.size() <= small_meeting || nodes.size() == 1) {
      visit_(crowd, nodes);
      return;
    }
    std::vector<int> part_crowd;
    std::vector<int> part_nodes;
    for (const Quadrant& part : parts_of(quadrant)) {
      part_nodes.clear();
      part_crowd.clear();
      std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(part_nodes),
                   [&](int node) { return part.holds(nodes_[at(node)]); });
      if (part_nodes.empty()) continue;
      std::copy_if(crowd.begin(), crowd.end(), std::back_inserter(part_crowd),
                   [&](int piece) { return comes_near(part, pieces_[at(piece)].segment, reach_); });
      divide(part, part_crowd, part_nodes);
    }
  }

 private:
  const std::vector<Piece>& pieces_;
  const std::vector<Pixel>& nodes_;
  double reach_;
  const std::function<void(const std::vector<int>&, const std::vector<int>&)>& visit_;
};

}  // namespace

void visit_crowds(const std::vector<Piece>& pieces,
                  const std::function<void(const Quadrant&, const std::vector<int>&)>& visit) {
  if (pieces.empty()) return;
  Crowds(pieces, visit).divide(root_of(pieces), all_of(pieces.size()), 0);
}

void visit_meetings(const std::vector<Piece>& pieces, const std::vector<Pixel>& nodes, double reach,
                    const std::function<void(const std::vector<int>&, const std::vector<int>&)>& visit) {
  if (pieces.empty()) return;
  Meetings(pieces, nodes, reach, visit).divide(root_of(pieces), all_of(pieces.size()), all_of(nodes.size()));
}

}  // namespace dda
