// The edges of a polygon of many corners, found by where they are: a large block with thousands of small neighbours, or
// with thousands of holes, is looked at once for each of them.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {

// From this number of corners on an index costs less than looking at all edges.
inline constexpr std::size_t corners_worth_an_index = 64;

// Corners of the outline and of all holes.
[[nodiscard]] std::size_t corner_count(const Polygon& polygon);

// Visits the outline's edges, then those of the holes, each from corner to corner in the order of the rings.
template <typename Visit>
void for_each_edge(const Polygon& polygon, const Visit& visit) {
  const auto go_round = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(Segment{ring[i], ring[(i + 1) % ring.size()]});
  };
  go_round(polygon.outer);
  for (const Ring& hole : polygon.holes) go_round(hole);
}
[[nodiscard]] std::vector<Segment> edges_of(const Polygon& polygon);

class EdgeIndex {
 public:
  explicit EdgeIndex(const Polygon& polygon);

  [[nodiscard]] const std::vector<Segment>& edges() const { return edges_; }

  // Indices of the edges whose boxes meet `box`, in ascending order.
  [[nodiscard]] std::vector<int> near(const Box& box) const { return boxes_.overlapping(box); }

  // What dda::locate says of the polygon, whose holes may be in any order and turn either way.
  [[nodiscard]] Location locate(const Vec2& point, double tolerance = 0) const;

 private:
  void sort_into_rows();
  [[nodiscard]] std::size_t row_of(double y) const;
  [[nodiscard]] bool is_inside(const Vec2& point) const;

  std::vector<Segment> edges_;
  Box box_;
  BoxIndex boxes_;
  // Which edges cross a horizontal line is asked of rows of equal height, about as many as a line has edges in a
  // polygon that fills its box: each row has its edges one behind the other.
  std::size_t rows_ = 1;
  std::vector<std::size_t> row_begin_;
  std::vector<int> in_rows_;
};

}  // namespace dda
