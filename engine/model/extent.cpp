#include "engine/model/extent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

template <typename Visit>
void for_each_corner(const Model& model, const Visit& visit) {
  for (const Block& block : model.blocks)
    for (const Vec2& corner : block.shape.outer) visit(corner);
}

Vec2 farthest_along(const Vec2& way, const Model& model) {
  Vec2 end = Vec2::Zero();
  double farthest = -std::numeric_limits<double>::infinity();
  for_each_corner(model, [&](const Vec2& corner) {
    if (way.dot(corner) <= farthest) return;
    farthest = way.dot(corner);
    end = corner;
  });
  return end;
}

// A box within the quadrilateral of the four corners that lie farthest along the diagonals of the axes: each of its
// sides lies inside of both ends of a side of that. May be empty.
Box box_within(const Model& model) {
  const Vec2 upper_right = farthest_along({1, 1}, model), lower_left = farthest_along({-1, -1}, model);
  const Vec2 lower_right = farthest_along({1, -1}, model), upper_left = farthest_along({-1, 1}, model);
  return {lower_left.cwiseMax(Vec2(upper_left.x(), lower_right.y())),
          upper_right.cwiseMin(Vec2(lower_right.x(), upper_left.y()))};
}

// Those that may be ends of the longest way: few of those of rock in many blocks.
std::vector<Vec2> outer_corners(const Model& model) {
  std::vector<Vec2> corners;
  const Box within = box_within(model);
  for_each_corner(model, [&](const Vec2& corner) {
    const bool is_inside = (corner.array() > within.lower.array() && corner.array() < within.upper.array()).all();
    if (!is_inside) corners.push_back(corner);
  });
  return corners;
}

}  // namespace

double diameter(const Model& model) {
  std::vector<Vec2> corners = outer_corners(model);
  std::ranges::sort(corners, {}, [](const Vec2& corner) { return std::pair(corner.x(), corner.y()); });
  std::vector<Vec2> hull;
  append_half_of_hull(corners, 1, hull);
  append_half_of_hull(corners, -1, hull);
  double largest = 0;
  for (const Vec2& one : hull)
    for (const Vec2& other : hull) largest = std::max(largest, (one - other).norm());
  return largest;
}

Vec2 local_origin(const Model& model, double diameter) {
  if (diameter == 0) return Vec2::Zero();
  const double unit = std::exp2(std::ilogb(diameter) + 3);
  const Box box = bounding_box(model);
  const Vec2 middle = (box.lower + box.upper) / 2;
  return unit * Vec2(std::round(middle.x() / unit), std::round(middle.y() / unit));
}

}  // namespace dda
