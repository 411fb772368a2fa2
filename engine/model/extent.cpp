#include "engine/model/extent.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

// The corners of the convex hull from left to right, on the side that lies below `side` times y (Andrew's chain).
void append_half_of_hull(const std::vector<Vec2>& sorted, double side, std::vector<Vec2>& hull) {
  const std::size_t first = hull.size();
  for (const Vec2& point : sorted) {
    const auto turns_away = [&](const Vec2& before, const Vec2& last) {
      return side * cross(last - before, point - before) <= 0;
    };
    while (hull.size() >= first + 2 && turns_away(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(point);
  }
}

}  // namespace

double diameter(const Model& model) {
  std::vector<Vec2> corners;
  for (const Block& block : model.blocks)
    corners.insert(corners.end(), block.shape.outer.begin(), block.shape.outer.end());
  std::ranges::sort(corners, {}, [](const Vec2& corner) { return std::pair(corner.x(), corner.y()); });
  std::vector<Vec2> hull;
  append_half_of_hull(corners, 1, hull);
  append_half_of_hull(corners, -1, hull);
  double largest = 0;
  for (const Vec2& one : hull)
    for (const Vec2& other : hull) largest = std::max(largest, (one - other).norm());
  return largest;
}

}  // namespace dda
