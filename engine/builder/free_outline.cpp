#include "engine/builder/free_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

using Intervals = std::vector<std::pair<double, double>>;  // m along an edge

std::vector<std::vector<int>> neighbours_of(const Model& model, double tolerance) {
  std::vector<Box> boxes;
  for (const Block& block : model.blocks) boxes.push_back(expanded(bounding_box(block.shape), tolerance));
  std::vector<std::vector<int>> neighbours(boxes.size());
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    neighbours[static_cast<std::size_t>(a)].push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
  }
  return neighbours;
}

// What of `length` the intervals leave, but for slivers.
Intervals gaps_between(Intervals covered, double length, double tolerance) {
  std::sort(covered.begin(), covered.end());
  Intervals gaps;
  double reached = 0;
  covered.emplace_back(length, length);
  for (const auto& [from, to] : covered) {
    if (from - reached > tolerance) gaps.emplace_back(reached, from);
    reached = std::max(reached, to);
  }
  return gaps;
}

// Where the neighbours lie along `edge`.
Intervals covered_parts(const Segment& edge, const std::vector<int>& neighbours, const Model& model, double tolerance) {
  const Vec2 along = (edge.end - edge.start).normalized();
  Intervals covered;
  for (const int other : neighbours) {
    for (const Segment& side : edges_of(model.blocks[static_cast<std::size_t>(other)].shape)) {
      if (const auto common = collinear_overlap(edge, side, tolerance))
        covered.emplace_back(along.dot(common->first - edge.start), along.dot(common->second - edge.start));
    }
  }
  return covered;
}

std::vector<Stretch> free_stretches(const Model& model, double tolerance) {
  const auto neighbours = neighbours_of(model, tolerance);
  std::vector<Stretch> found;
  for (std::size_t block = 0; block < model.blocks.size(); ++block) {
    for (const Segment& edge : edges_of(model.blocks[block].shape)) {
      const double length = (edge.end - edge.start).norm();
      const Vec2 along = (edge.end - edge.start) / length;
      for (const auto& [from, to] :
           gaps_between(covered_parts(edge, neighbours[block], model, tolerance), length, tolerance)) {
        found.push_back(
            {static_cast<int>(block), edge.start + from * along, edge.start + to * along, Vec2(-along.y(), along.x())});
      }
    }
  }
  return found;
}

// Stretches by where they start.
class Starts {
 public:
  Starts(const std::vector<Stretch>& stretches, double tolerance) : stretches_(&stretches), tolerance_(tolerance) {
    for (std::size_t i = 0; i < stretches.size(); ++i) by_x_.emplace_back(stretches[i].from.x(), i);
    std::sort(by_x_.begin(), by_x_.end());
  }

  // The stretch that goes on along the same empty space, which lies on the right of `stretch`: of those that start at
  // its end, the first that a ray turning counter-clockwise from where it came meets.
  [[nodiscard]] std::optional<std::size_t> after(const Stretch& stretch) const {
    const Vec2 back = stretch.from - stretch.to;
    std::optional<std::size_t> next;
    double least_turn = std::numeric_limits<double>::infinity();
    auto at = std::lower_bound(by_x_.begin(), by_x_.end(), std::pair(stretch.to.x() - tolerance_, std::size_t{0}));
    for (; at != by_x_.end() && at->first <= stretch.to.x() + tolerance_; ++at) {
      const Stretch& candidate = (*stretches_)[at->second];
      if ((candidate.from - stretch.to).norm() > tolerance_) continue;
      const double turn = angle(back, candidate.to - candidate.from);
      if (turn < least_turn) {
        least_turn = turn;
        next = at->second;
      }
    }
    return next;
  }

 private:
  // From a to b, counter-clockwise, in (0, 2 pi].
  static double angle(const Vec2& a, const Vec2& b) {
    const double turn = std::atan2(cross(a, b), a.dot(b));
    return turn > 0 ? turn : turn + 2 * std::numbers::pi;
  }

  const std::vector<Stretch>* stretches_;
  double tolerance_;
  std::vector<std::pair<double, std::size_t>> by_x_;
};

Ring corners(const FreeRing& ring) {
  Ring points;
  for (const Stretch& stretch : ring) points.push_back(stretch.from);
  return points;
}

// Rings with the material outside turn clockwise.
bool is_opening(const FreeRing& ring) { return signed_area(corners(ring)) < 0; }

bool encloses(const FreeRing& ring, const Vec2& point) {
  return locate({corners(ring), {}}, point) == Location::inside;
}

}  // namespace

std::vector<FreeRing> free_rings(const Model& model) {
  const std::vector<Stretch> stretches = free_stretches(model, point_tolerance(model));
  const Starts starts(stretches, 4 * point_tolerance(model));
  std::vector<bool> used(stretches.size(), false);
  std::vector<FreeRing> rings;
  for (std::size_t first = 0; first < stretches.size(); ++first) {
    FreeRing ring;
    std::optional<std::size_t> at = first;
    while (at && !used[*at]) {
      used[*at] = true;
      ring.push_back(stretches[*at]);
      at = starts.after(stretches[*at]);
    }
    if (at == first && ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

FreeRing ring_around(const std::vector<FreeRing>& rings, const Vec2& point) {
  const FreeRing* tightest = nullptr;
  double least_area = std::numeric_limits<double>::infinity();
  for (const FreeRing& ring : rings) {
    const double area = -signed_area(corners(ring));
    if (area <= 0 || area >= least_area || !encloses(ring, point)) continue;
    tightest = &ring;
    least_area = area;
  }
  return tightest != nullptr ? *tightest : FreeRing{};
}

FreeRing outer_rings(const std::vector<FreeRing>& rings) {
  FreeRing outer;
  for (const FreeRing& ring : rings) {
    if (is_opening(ring)) continue;
    const bool inside = std::any_of(rings.begin(), rings.end(), [&ring](const FreeRing& other) {
      return is_opening(other) && encloses(other, ring.front().from);
    });
    if (!inside) outer.insert(outer.end(), ring.begin(), ring.end());
  }
  return outer;
}

}  // namespace dda
