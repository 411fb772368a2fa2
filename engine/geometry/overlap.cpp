#include "engine/geometry/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/geometry/edge_index.h"
#include "engine/geometry/nearness.h"
#include "engine/geometry/segment.h"

// With E(B) the part of B deeper than the tolerance, A and E(B) meet if and only if an edge of A meets E(B) or, no edge
// of A entering E(B), A holds a whole component of E(B). The first is decided on each edge: what the strips of
// half-width `tolerance` about the edges of B leave free of it is in E(B) or outside B, piece by piece. The second is
// decided at one point of each stretch of the boundary of (nearly) E(B).

namespace dda {
namespace {

struct Interval {
  double first;
  double last;
};

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Interval nowhere = {infinite, -infinite};

Interval meet(const Interval& a, const Interval& b) { return {std::max(a.first, b.first), std::min(a.last, b.last)}; }

Interval hull(const Interval& a, const Interval& b) {
  if (a.first > a.last) return b;
  if (b.first > b.last) return a;
  return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

// Returns for which t lower <= constant + slope t <= upper.
Interval between(double constant, double slope, double lower, double upper) {
  if (slope == 0) return constant >= lower && constant <= upper ? Interval{-infinite, infinite} : nowhere;
  const double at_lower = (lower - constant) / slope;
  const double at_upper = (upper - constant) / slope;
  return {std::min(at_lower, at_upper), std::max(at_lower, at_upper)};
}

// The parameters of the line through `line` within `radius` of `centre`.
Interval within_disc(const Segment& line, const Vec2& centre, double radius) {
  const Vec2 along = line.end - line.start;
  const double length = along.norm();
  const double off = cross(along, centre - line.start) / length;
  if (std::abs(off) > radius) return nowhere;
  const double middle = along.dot(centre - line.start) / (length * length);
  const double half = std::sqrt((radius - off) * (radius + off)) / length;
  return {middle - half, middle + half};
}

// The parameters of the line through `line` within `radius` of the segment `core`: one interval, as that set is convex.
Interval within_strip(const Segment& line, const Segment& core, double radius) {
  const Vec2 along = line.end - line.start;
  const Vec2 direction = (core.end - core.start).normalized();
  const double length = (core.end - core.start).norm();
  const Vec2 start = line.start - core.start;
  const Interval beside = meet(between(direction.dot(start), direction.dot(along), 0, length),
                               between(cross(direction, start), cross(direction, along), -radius, radius));
  return hull(beside, hull(within_disc(line, core.start, radius), within_disc(line, core.end, radius)));
}

struct Shape {
  explicit Shape(const Polygon& given)
      : polygon(normalized(given)), edges(edges_of(polygon)), box(bounding_box(given)) {}

  void make_index() { index.emplace(polygon); }

  // Whether `holds` for an edge, of those whose box meets `near` at least; each is asked until one does.
  template <typename Condition>
  bool any_edge(const Box& near, const Condition& holds) const {
    if (!index)
      return std::ranges::any_of(edges,
                                 [&](const Segment& edge) { return overlap(edge_box(edge, 0), near) && holds(edge); });
    const std::vector<int> found = index->near(near);
    return std::any_of(found.begin(), found.end(), [&](int i) { return holds(edges[static_cast<std::size_t>(i)]); });
  }

  Polygon polygon;
  std::vector<Segment> edges;  // material on the left
  Box box;
  std::optional<EdgeIndex> index;
};

bool is_inside(const Shape& shape, const Vec2& point) {
  return (shape.index ? shape.index->locate(point) : locate(shape.polygon, point)) == Location::inside;
}

// A point of each piece of `segment` that is farther than `tolerance` from all edges of `shape` and inside it.
std::vector<Vec2> deep_points(const Segment& segment, const Shape& shape, double tolerance) {
  std::vector<Interval> covered;
  shape.any_edge(edge_box(segment, 2 * tolerance), [&](const Segment& edge) {  // twice: room for round-off
    const Interval near = meet(within_strip(segment, edge, tolerance), {0, 1});
    if (near.first <= near.last) covered.push_back(near);
    return false;
  });
  covered.push_back({1, 1});
  std::sort(covered.begin(), covered.end(), [](const Interval& p, const Interval& q) { return p.first < q.first; });
  std::vector<Vec2> points;
  double reached = 0;
  for (const Interval& next : covered) {
    const Vec2 middle = point_at(segment, (reached + next.first) / 2);
    if (next.first > reached && is_inside(shape, middle)) points.push_back(middle);
    reached = std::max(reached, next.last);
  }
  return points;
}

bool box_meets(const Segment& segment, const Box& box) { return overlap(edge_box(segment, 0), box); }

bool edge_enters(const Shape& a, const Shape& b, double tolerance) {
  const Box deep = expanded(b.box, -tolerance);
  return a.any_edge(
      deep, [&](const Segment& edge) { return box_meets(edge, deep) && !deep_points(edge, b, tolerance).empty(); });
}

// Whether `a` holds a component of the deep part of `b`, if no edge of either enters the deep part of the other. Then
// `b` holds a part of `a` as well, so that one direction is enough.
bool holds_deep_part(const Shape& a, const Shape& b, double tolerance) {
  return b.any_edge(expanded(a.box, 2 * tolerance), [&](const Segment& edge) {
    const Vec2 along = (edge.end - edge.start).normalized();
    const Vec2 inward = 1.5 * tolerance * Vec2(-along.y(), along.x());  // half as much again, for round-off
    const Segment inner = {edge.start + inward, edge.end + inward};
    if (!box_meets(inner, a.box)) return false;
    const std::vector<Vec2> points = deep_points(inner, b, tolerance);
    return std::any_of(points.begin(), points.end(), [&](const Vec2& point) { return is_inside(a, point); });
  });
}

// How far a ring lies to the left of a line through `origin`, m: least and most.
std::pair<double, double> reach_left(const Ring& ring, const Vec2& origin, const Vec2& along) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec2& vertex : ring) {
    const double left = cross(along, Vec2(vertex - origin));
    least = std::min(least, left);
    most = std::max(most, left);
  }
  return {least, most};
}

// Whether the line of an edge of `a` has all of `a` on one side and all of `b` on the other, but for a quarter of the
// tolerance: what both have is then nowhere deeper than half of it. Neighbours cut from one rock mostly are.
bool is_parted_by_edge(const Ring& a, const Ring& b, double tolerance) {
  const double allowed = tolerance / 4;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2& origin = a[i];
    const Vec2 along = (a[(i + 1) % a.size()] - origin).normalized();
    const auto [least_b, most_b] = reach_left(b, origin, along);
    if (most_b > allowed && least_b < -allowed) continue;
    const auto [least_a, most_a] = reach_left(a, origin, along);
    if ((least_a >= -allowed && most_b <= allowed) || (most_a <= allowed && least_b >= -allowed)) return true;
  }
  return false;
}

// Looking at each of many corners from each of many edges would cost more than it spares.
bool are_parted(const Ring& a, const Ring& b, double tolerance) {
  constexpr std::size_t few = 16;
  return a.size() <= few && b.size() <= few &&
         (is_parted_by_edge(a, b, tolerance) || is_parted_by_edge(b, a, tolerance));
}

bool shapes_overlap(const Shape& a, const Shape& b, double tolerance) {
  if (!overlap(a.box, b.box)) return false;
  if (edge_enters(a, b, tolerance) || edge_enters(b, a, tolerance)) return true;
  // The one with fewer edges is gone around.
  return a.edges.size() < b.edges.size() ? holds_deep_part(b, a, tolerance) : holds_deep_part(a, b, tolerance);
}

}  // namespace

bool interiors_overlap(const Polygon& a, const Polygon& b, double tolerance) {
  if (are_parted(a.outer, b.outer, tolerance)) return false;
  return shapes_overlap(Shape(a), Shape(b), tolerance);
}

struct Overlaps::Indexed : Shape {
  explicit Indexed(const Polygon& given) : Shape(given) { make_index(); }
};

// Where corners are so few that looking at all edges costs less there is no index.
Overlaps::Overlaps(std::vector<const Polygon*> polygons) : polygons_(std::move(polygons)), indexed_(polygons_.size()) {
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    if (corner_count(*polygons_[i]) >= corners_worth_an_index)
      indexed_[i] = std::make_unique<const Indexed>(*polygons_[i]);
  }
}
Overlaps::~Overlaps() = default;

bool Overlaps::between(int a, int b, double tolerance) const {
  const Polygon& first = *polygons_[static_cast<std::size_t>(a)];
  const Polygon& second = *polygons_[static_cast<std::size_t>(b)];
  const Indexed* large_a = indexed_[static_cast<std::size_t>(a)].get();
  const Indexed* large_b = indexed_[static_cast<std::size_t>(b)].get();
  if (large_a == nullptr && large_b == nullptr) return interiors_overlap(first, second, tolerance);
  if (large_a == nullptr) return shapes_overlap(Shape(first), *large_b, tolerance);
  if (large_b == nullptr) return shapes_overlap(*large_a, Shape(second), tolerance);
  return shapes_overlap(*large_a, *large_b, tolerance);
}

}  // namespace dda
