#include "engine/reaction/opening_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/contact/interface.h"
#include "engine/model/common_centroid.h"

namespace dda {
namespace {

// Says of every block whether it is one of these.
std::vector<bool> marked(const std::vector<int>& blocks, const Model& model) {
  std::vector<bool> marks(model.blocks.size(), false);
  for (const int block : blocks) marks[static_cast<std::size_t>(block)] = true;
  return marks;
}

// How far it is from `start` to where the ray crosses the face, m; nothing where it passes the face.
std::optional<double> distance_to(const WallFace& face, const Vec2& start, const Vec2& direction, double tolerance) {
  const Vec2 along = face.to - face.from;
  const Vec2 across(-direction.y(), direction.x());
  const double slope = across.dot(along);
  if (std::abs(slope) <= tolerance) return std::nullopt;  // the face lies along the ray
  const double share = across.dot(start - face.from) / slope;
  const double reach = tolerance / along.norm();
  if (share < -reach || share > 1 + reach) return std::nullopt;
  const double distance = direction.dot(face.from + share * along - start);
  return distance > 0 ? std::optional(distance) : std::nullopt;
}

std::vector<WallPoint> last_crossings(const OpeningWall& wall, const Vec2& direction, double tolerance) {
  double farthest = 0;
  for (const WallFace& face : wall.faces)
    farthest = std::max(farthest, distance_to(face, wall.centroid, direction, tolerance).value_or(0));
  std::vector<WallPoint> points;
  for (const WallFace& face : wall.faces) {
    const std::optional<double> distance = distance_to(face, wall.centroid, direction, tolerance);
    if (distance && *distance >= farthest - tolerance)
      points.push_back({face.block, wall.centroid + *distance * direction});
  }
  return points;
}

double inward_at(WallPlace place, const OpeningWall& wall, const auto& moved) {
  const std::vector<WallPoint>& points = wall.places[static_cast<std::size_t>(place)];
  if (points.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const WallPoint& point : points) sum -= outward_at(place).dot(moved(point.block, point.point));
  return sum / static_cast<double>(points.size());
}

}  // namespace

Vec2 outward_at(WallPlace place) {
  constexpr std::array<std::array<double, 2>, 4> directions{{{0, 1}, {-1, 0}, {1, 0}, {0, -1}}};
  const auto& [x, y] = directions[static_cast<std::size_t>(place)];
  return {x, y};
}

OpeningWall wall_of(const std::vector<int>& opening, const std::vector<bool>& absent, const Model& model) {
  const std::vector<bool> is_taken = marked(opening, model);
  const auto stays = [&](int block) {
    const auto i = static_cast<std::size_t>(block);
    return !is_taken[i] && (absent.empty() || !absent[i]);
  };
  OpeningWall wall;
  wall.centroid = common_centroid(opening, model);
  for (const Interface& face : find_interfaces(model)) {
    if (face.length == 0) continue;  // corners that touch have no wall between them
    const bool a_is_taken = is_taken[static_cast<std::size_t>(face.block_a)];
    const bool b_is_taken = is_taken[static_cast<std::size_t>(face.block_b)];
    if (b_is_taken && stays(face.block_a)) wall.faces.push_back({face.block_a, face.from, face.to, face.normal});
    if (a_is_taken && stays(face.block_b)) wall.faces.push_back({face.block_b, face.to, face.from, -face.normal});
  }
  for (const WallFace& face : wall.faces) wall.length += face.length();
  for (const WallPlace place : wall_places)
    wall.places[static_cast<std::size_t>(place)] = last_crossings(wall, outward_at(place), model.length_tolerance);
  return wall;
}

OpeningWall without(const std::vector<int>& blocks, OpeningWall wall) {
  const auto is_left_out = [&](const auto& part) { return std::ranges::find(blocks, part.block) != blocks.end(); };
  if (std::ranges::all_of(wall.faces, is_left_out)) return wall;
  std::erase_if(wall.faces, is_left_out);
  for (std::vector<WallPoint>& points : wall.places) std::erase_if(points, is_left_out);
  wall.length = 0;
  for (const WallFace& face : wall.faces) wall.length += face.length();
  return wall;
}

WallMotion motion_of(const OpeningWall& wall, const Model& model, const State& before, const State& after) {
  const auto moved = [&](int block, const Vec2& point) -> Vec2 {
    return point_displacement(model, after, block, point) - point_displacement(model, before, block, point);
  };
  WallMotion motion;
  motion.largest = -std::numeric_limits<double>::infinity();
  for (const WallFace& face : wall.faces) {
    const double inward = face.inward.dot(moved(face.block, (face.from + face.to) / 2));
    motion.mean += face.length() / wall.length * inward;
    if (inward <= motion.largest) continue;
    motion.largest = inward;
    motion.block = face.block;
  }
  for (const WallPlace place : wall_places)
    motion.places[static_cast<std::size_t>(place)] = inward_at(place, wall, moved);
  return motion;
}

}  // namespace dda
