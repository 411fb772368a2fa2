#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/nearness.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

using Reason = std::optional<std::string>;

constexpr double largest_coordinate = 1e12;  // m; keeps fourth powers and grid indices far from overflow

struct Edge {
  Segment segment;
  std::size_t ring;  // 0 the outer ring, i the hole i - 1
  std::size_t index;
  std::size_t ring_size;
};

std::string name_of(std::size_t ring) { return ring == 0 ? "the outer ring" : fmt::format("hole {}", ring - 1); }

std::vector<const Ring*> rings_of(const Polygon& polygon) {
  std::vector<const Ring*> rings = {&polygon.outer};
  for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  return rings;
}

Reason vertex_defect(const Ring& ring, const std::string& name) {
  if (ring.size() < 3) return fmt::format("degenerate: {} has fewer than 3 vertices ({})", name, ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].lpNorm<Eigen::Infinity>() <= largest_coordinate && ring[i].allFinite()) continue;
    return fmt::format("out of range: vertex {} of {} is ({}, {}) m", i, name, ring[i].x(), ring[i].y());
  }
  return std::nullopt;
}

Reason repetition(const Ring& ring, const std::string& name, double tolerance) {
  std::vector<Box> boxes;
  for (const Vec2& vertex : ring) boxes.push_back(vertex_box(vertex, tolerance));
  const std::vector<std::pair<int, int>> pairs = overlapping_pairs(boxes);
  if (pairs.empty()) return std::nullopt;
  return fmt::format("degenerate: vertex {} of {} repeats vertex {}", pairs.front().second, name, pairs.front().first);
}

Reason conflict_in_ring(const Edge& a, const Edge& b, double tolerance) {
  const std::string name = name_of(a.ring);
  const bool b_follows = b.index == a.index + 1;
  const bool a_follows = a.index == 0 && b.index + 1 == b.ring_size;
  if (!b_follows && !a_follows) {
    if (!touch(a.segment, b.segment, tolerance)) return std::nullopt;
    return fmt::format("self-intersecting: edge {} of {} crosses or touches edge {}", a.index, name, b.index);
  }
  if ((b_follows && folds_back(a.segment, b.segment, tolerance)) ||
      (a_follows && folds_back(b.segment, a.segment, tolerance))) {
    return fmt::format("self-intersecting: edge {} of {} folds back onto edge {}", a.index, name, b.index);
  }
  return std::nullopt;
}

Reason conflict(const Edge& a, const Edge& b, double tolerance) {
  if (a.ring == b.ring) return conflict_in_ring(a, b, tolerance);
  if (!touch(a.segment, b.segment, tolerance)) return std::nullopt;
  return fmt::format("self-intersecting: {} crosses or touches {}", name_of(b.ring), name_of(a.ring));
}

std::vector<Edge> edges_by_ring(const Polygon& polygon) {
  std::vector<Edge> edges;
  const std::vector<const Ring*> rings = rings_of(polygon);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({{ring[i], ring[(i + 1) % ring.size()]}, r, i, ring.size()});
    }
  }
  return edges;
}

Reason edge_defect(const Polygon& polygon, double tolerance) {
  const std::vector<Edge> edges = edges_by_ring(polygon);
  std::vector<Box> boxes;
  for (const Edge& edge : edges) boxes.push_back(edge_box(edge.segment, tolerance));
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    Reason reason = conflict(edges[static_cast<std::size_t>(i)], edges[static_cast<std::size_t>(j)], tolerance);
    if (reason) return reason;
  }
  return std::nullopt;
}

// The rings must neither cross nor touch: one vertex then tells where a hole lies. Only holes whose boxes hold the
// vertex are asked, as rock between short joints has thousands of holes that are far from each other.
Reason nesting_defect(const Polygon& polygon) {
  if (polygon.holes.empty()) return std::nullopt;
  const EdgeIndex outer({polygon.outer, {}});
  std::vector<Box> boxes;
  for (const Ring& hole : polygon.holes) boxes.push_back(bounding_box(hole));
  const BoxIndex index(std::move(boxes));
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    const Vec2& vertex = polygon.holes[i].front();
    if (outer.locate(vertex) == Location::outside)
      return fmt::format("inconsistent: hole {} lies outside the outer ring", i);
    for (const int other : index.overlapping({vertex, vertex})) {
      const auto j = static_cast<std::size_t>(other);
      if (j == i || !contains({polygon.holes[j], {}}, vertex)) continue;
      return fmt::format("inconsistent: hole {} lies inside hole {}", i, j);
    }
  }
  return std::nullopt;
}

// The fourth powers of lengths below about 1e-80 m vanish.
Reason moment_defect(const Polygon& polygon) {
  const AreaMoments moments = area_moments(polygon);
  if (moments.area > 0 && moments.xx > 0 && moments.yy > 0) return std::nullopt;
  return fmt::format("degenerate: its area is {} m2, its second moments {} and {} m4", moments.area, moments.xx,
                     moments.yy);
}

}  // namespace

double largest_coordinate_of(const Ring& ring) {
  double largest = 0;
  for (const Vec2& vertex : ring) largest = std::max(largest, vertex.lpNorm<Eigen::Infinity>());
  return largest;
}

bool is_flat(const Ring& ring, double tolerance) {
  const auto farther = [&](const Vec2& p, const Vec2& q) {
    return (p - ring.front()).squaredNorm() < (q - ring.front()).squaredNorm();
  };
  const Segment longest = {ring.front(), *std::max_element(ring.begin(), ring.end(), farther)};
  return std::all_of(ring.begin(), ring.end(), [&](const Vec2& p) { return distance(longest, p) <= tolerance; });
}

std::optional<std::string> defect(const Polygon& polygon) {
  const std::vector<const Ring*> rings = rings_of(polygon);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (Reason reason = vertex_defect(*rings[r], name_of(r))) return reason;
  }
  const double tolerance = coordinate_tolerance(largest_coordinate_of(polygon.outer));
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (is_flat(*rings[r], tolerance)) return fmt::format("degenerate: {} has no area", name_of(r));
    if (Reason reason = repetition(*rings[r], name_of(r), tolerance)) return reason;
  }
  if (Reason reason = edge_defect(polygon, tolerance)) return reason;
  if (Reason reason = nesting_defect(polygon)) return reason;
  return moment_defect(polygon);
}

}  // namespace dda
