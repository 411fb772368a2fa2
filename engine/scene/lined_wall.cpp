#include "engine/scene/lined_wall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "engine/builder/free_outline.h"
#include "engine/builder/separate_places.h"
#include "engine/core/error.h"
#include "engine/geometry/polygon.h"
#include "engine/model/tolerance.h"
#include "engine/scene/places.h"
#include "engine/scene/present_blocks.h"

namespace dda {
namespace {

std::string written(const Vec2& point) { return fmt::format("[{:.6g}, {:.6g}]", point.x(), point.y()); }

Vec2 middle_of(const Stretch& face) { return (face.from + face.to) / 2; }

// Takes from a wall that closes on itself the one run of faces whose middles lie above `height` (m).
LinedWall part_above(const Field& field, double height, const std::vector<Stretch>& wall) {
  const auto is_above = [&](const Stretch& face) { return middle_of(face).y() > height; };
  const auto below = std::ranges::find_if_not(wall, is_above);
  if (below == wall.end()) return {wall, true};
  std::vector<Stretch> turned(wall.begin(), wall.end());
  std::rotate(turned.begin(), turned.begin() + (below - wall.begin()), turned.end());
  const auto first = std::ranges::find_if(turned, is_above);
  const auto last = std::find_if_not(first, turned.end(), is_above);
  if (first == turned.end()) field.fail("a height below the roof of the opening");
  if (std::find_if(last, turned.end(), is_above) != turned.end())
    field.fail("a height above which the wall is one piece");
  return {{first, last}, false};
}

LinedWall around(const Field& lining, const Field& place, const Vec2& point, const PresentBlocks& present) {
  const FreeRing ring = ring_around(free_rings(present.model), point);
  if (ring.empty())
    place.fail("an opening with blocks all around, and without blocks inside once the lining's stage has begun");
  const std::vector<Stretch> wall = present.in_whole(ring);
  const auto height = lining.find("above");
  return height ? part_above(*height, height->quantity(Dimension::length), wall) : LinedWall{wall, true};
}

// The faces along one piece of the line, in its direction; none where blocks touch.
std::vector<Stretch> faces_along(const Field& field, const Segment& piece, const GroundPlan& plan, double tolerance) {
  std::vector<Stretch> faces = plan.stretches_along(piece);
  const Vec2 along = (piece.end - piece.start).normalized();
  const auto begin = [&](const Stretch& face) {
    return std::min(along.dot(face.from - piece.start), along.dot(face.to - piece.start));
  };
  std::ranges::sort(faces, {}, begin);
  double reached = 0;
  for (const Stretch& face : faces) {
    const double from = begin(face);
    const Vec2 at = piece.start + reached * along;
    if (from < reached - tolerance)
      field.fail("along a joint at " + written(piece.start + from * along), "a line along free faces of blocks");
    if (from > reached + tolerance) field.fail("past no block at " + written(at), "a line along free faces of blocks");
    reached = from + (face.to - face.from).norm();
  }
  if (reached < (piece.end - piece.start).norm() - tolerance)
    field.fail("past no block at " + written(piece.start + reached * along), "a line along free faces of blocks");
  return faces;
}

// A beam that passes a face a second time would be there twice.
void expect_each_once(const Field& field, const std::vector<Stretch>& faces, const Model& model, double tolerance) {
  for (std::size_t i = 1; i < faces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (faces[i].block != faces[j].block) continue;
      const auto common = collinear_overlap({faces[i].from, faces[i].to}, {faces[j].from, faces[j].to}, tolerance);
      if (!common) continue;
      field.fail(fmt::format("past the face of \"{}\" at {} twice",
                             model.blocks[static_cast<std::size_t>(faces[i].block)].name,
                             written((common->first + common->second) / 2)),
                 "a line that passes each face once: the lining would be there twice");
    }
}

LinedWall along_line(const Field& field, bool closed, const PresentBlocks& present) {
  std::vector<Vec2> points;
  for (const Field& item : field.items()) points.push_back(item.vector(Dimension::length));
  if (closed) points.push_back(points.front());
  const GroundPlan plan(present.model);
  const double tolerance = point_tolerance(present.model);
  LinedWall wall{{}, closed};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) field.fail("the point " + written(points[i]) + " twice", "points that differ");
    std::ranges::copy(faces_along(field, {points[i - 1], points[i]}, plan, tolerance), std::back_inserter(wall.faces));
  }
  // Outlines have the material on the left: all of the faces point along the line, or all against it.
  const Vec2 start = points[1] - points[0];
  const bool reversed = start.dot(wall.faces.front().to - wall.faces.front().from) < 0;
  if (reversed) std::ranges::reverse(wall.faces);
  for (std::size_t i = 1; i < wall.faces.size(); ++i)
    if ((wall.faces[i].from - wall.faces[i - 1].to).norm() > 2 * tolerance)
      field.fail("on both sides of the rock at " + written(wall.faces[i].from), "a line with the rock on one side");
  expect_each_once(field, wall.faces, present.model, tolerance);
  wall.faces = present.in_whole(std::move(wall.faces));
  return wall;
}

Vec2 inside(const Ring& outline, double tolerance) {
  const Polygon shape = normalized(Polygon{outline, {}});
  Vec2 centroid = area_moments(shape).centroid;
  if (locate(shape, centroid, tolerance) == Location::inside) return centroid;
  // Near the middle of the longest edge, which has no other one close to it.
  std::size_t longest = 0;
  const auto edge = [&](std::size_t i) -> Vec2 { return shape.outer[(i + 1) % shape.outer.size()] - shape.outer[i]; };
  for (std::size_t i = 1; i < shape.outer.size(); ++i)
    if (edge(i).norm() > edge(longest).norm()) longest = i;
  const Vec2 along = edge(longest);
  return shape.outer[longest] + along / 2 + 1e-3 * Vec2(-along.y(), along.x());
}

// The beam is one chain around one wall. What is still there by then has none yet.
void expect_one_place(const Field& name, std::vector<int> blocks, std::size_t stage, const Model& model) {
  const std::vector<bool> away = model.absent_in(stage);
  std::erase_if(blocks, [&](int block) { return away.empty() || !away[static_cast<std::size_t>(block)]; });
  if (blocks.empty()) return;
  const auto places = separate_places(blocks, away, model);
  if (places.size() < 2) return;
  name.fail(in_several_places(name.text(), places, model),
            "an opening with one wall: a lining for each place, by a group of its own or a point in it (cavity)");
}

}  // namespace

// Returns a point in the outline that was drawn, or in a block of the group that is taken out.
Vec2 Walls::point_in_opening(const Field& name, std::size_t stage) const {
  const auto drawn = std::ranges::find(openings_, name.text(), &PlanOpening::name);
  if (drawn != openings_.end()) return inside(drawn->outline, model_.length_tolerance);
  const std::vector<int> blocks = blocks_called(name, groups_, model_);
  expect_one_place(name, blocks, stage, model_);
  return inside(model_.blocks[static_cast<std::size_t>(blocks.front())].shape.outer, model_.length_tolerance);
}

LinedWall Walls::of(const Field& lining, std::size_t stage) const {
  const int given = static_cast<int>(lining.has("opening")) + static_cast<int>(lining.has("cavity")) +
                    static_cast<int>(lining.has("along"));
  if (given != 1)
    throw InputError("", lining.path(), given == 0 ? "without a place" : "at several places",
                     "one of opening, cavity and along");
  const PresentBlocks present(model_, stage);
  if (const auto along = lining.find("along")) {
    refuse(lining, {"above"}, "beside along");
    return along_line(*along, value_or(lining, "closed", false, [](const Field& f) { return f.truth(); }), present);
  }
  refuse(lining, {"closed"}, "without along: the wall of an opening closes");
  if (const auto name = lining.find("opening")) return around(lining, *name, point_in_opening(*name, stage), present);
  const Field cavity = lining.at("cavity");
  return around(lining, cavity, cavity.vector(Dimension::length), present);
}

}  // namespace dda
