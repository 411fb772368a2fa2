#include "engine/geometry/edge_index.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/nearness.h"

namespace dda {
namespace {

std::vector<Box> boxes_of(const std::vector<Segment>& edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Segment& edge : edges) boxes.push_back(edge_box(edge, 0));
  return boxes;
}

}  // namespace

std::size_t corner_count(const Polygon& polygon) {
  std::size_t corners = polygon.outer.size();
  for (const Ring& hole : polygon.holes) corners += hole.size();
  return corners;
}

std::vector<Segment> edges_of(const Polygon& polygon) {
  std::vector<Segment> edges;
  edges.reserve(corner_count(polygon));
  for_each_edge(polygon, [&](const Segment& edge) { edges.push_back(edge); });
  return edges;
}

EdgeIndex::EdgeIndex(const Polygon& polygon)
    : edges_(edges_of(polygon)), box_(bounding_box(polygon)), boxes_(boxes_of(edges_)) {
  sort_into_rows();
}

std::size_t EdgeIndex::row_of(double y) const {
  const double share = (y - box_.lower.y()) / (box_.upper.y() - box_.lower.y());
  return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(rows_ - 1));
}

// Counts what each row has, then fills the rows.
void EdgeIndex::sort_into_rows() {
  rows_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges_.size()))) + 1;
  const auto for_rows_of = [this](const Segment& edge, const auto& visit) {
    const auto [low, high] = std::minmax(edge.start.y(), edge.end.y());
    for (std::size_t row = row_of(low); row <= row_of(high); ++row) visit(row);
  };
  row_begin_.assign(rows_ + 1, 0);
  for (const Segment& edge : edges_) for_rows_of(edge, [this](std::size_t row) { ++row_begin_[row + 1]; });
  for (std::size_t row = 0; row < rows_; ++row) row_begin_[row + 1] += row_begin_[row];
  in_rows_.resize(row_begin_.back());
  std::vector<std::size_t> next(row_begin_.begin(), row_begin_.end() - 1);
  for (std::size_t i = 0; i < edges_.size(); ++i)
    for_rows_of(edges_[i], [&](std::size_t row) { in_rows_[next[row]++] = static_cast<int>(i); });
}

Location EdgeIndex::locate(const Vec2& point, double tolerance) const {
  const std::vector<int> beside = near(expanded(Box{point, point}, tolerance));
  const bool on_edge = std::ranges::any_of(
      beside, [&](int i) { return distance(edges_[static_cast<std::size_t>(i)], point) <= tolerance; });
  if (on_edge) return Location::boundary;
  return is_inside(point) ? Location::inside : Location::outside;
}

// By how many edges a ray to the right crosses. A point beyond the box crosses none, as its y is that of no edge or all
// edges are on one side.
bool EdgeIndex::is_inside(const Vec2& point) const {
  const std::size_t row = row_of(point.y());
  bool inside = false;
  for (std::size_t k = row_begin_[row]; k < row_begin_[row + 1]; ++k) {
    const auto& [a, b] = edges_[static_cast<std::size_t>(in_rows_[k])];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double side = cross(Vec2(b - a), Vec2(point - a));
    if ((b.y() > a.y()) == (side > 0)) inside = !inside;
  }
  return inside;
}

}  // namespace dda
