#include "engine/geometry/diameter.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

bool turns_left(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(Vec2(b - a), Vec2(c - b)) > 0; }

// One side of the hull of points in order, from the first to the last (Andrew 1979).
template <typename Iterator>
std::vector<Vec2> chain(Iterator first, Iterator last) {
  std::vector<Vec2> hull;
  for (; first != last; ++first) {
    while (hull.size() > 1 && !turns_left(hull[hull.size() - 2], hull.back(), *first)) hull.pop_back();
    hull.push_back(*first);
  }
  return hull;
}

// Counter-clockwise, without points that lie on its sides.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::ranges::sort(points, {}, [](const Vec2& p) { return std::tuple(p.x(), p.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull = chain(points.begin(), points.end());
  const std::vector<Vec2> above = chain(points.rbegin(), points.rend());
  hull.insert(hull.end(), above.begin() + 1, above.end() - 1);
  return hull;
}

}  // namespace

// Each side of the hull with the corner that lies farthest from it, which goes around once while the sides do (Shamos
// 1978). Of the two corners beside that one round-off may have meant the other, so both are tried.
double diameter(std::vector<Vec2> points) {
  const std::vector<Vec2> hull = convex_hull(std::move(points));
  const std::size_t count = hull.size();
  const auto corner = [&](std::size_t i) -> const Vec2& { return hull[i % count]; };
  double largest = 0;
  for (std::size_t side = 0, far = 1; side < count; ++side) {
    const Vec2 along = corner(side + 1) - corner(side);
    const auto height = [&](std::size_t i) { return cross(along, Vec2(corner(i) - corner(side))); };
    while (height(far + 1) > height(far)) ++far;
    for (const std::size_t opposite : {far + count - 1, far, far + 1})
      for (const std::size_t end : {side, side + 1})
        largest = std::max(largest, (corner(opposite) - corner(end)).norm());
  }
  return largest;
}

}  // namespace dda
