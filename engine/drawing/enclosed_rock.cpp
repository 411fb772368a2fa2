#include "engine/drawing/enclosed_rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/cutting/cut_rock.h"
#include "engine/drawing/join_lines.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double room_around = 0.1;  // of the diagonal
constexpr double flat = 1e-3;        // of what counts as one place: corners that leave a straight line by less are none

Ring frame_around(const RockPlan& plan) {
  Box box;
  for (const PlanLine& line : plan.lines) {
    for (const Vec2& point : line.points) box = expanded(box, point);
  }
  box = expanded(box, room_around * (box.upper - box.lower).norm());
  return {box.lower, {box.upper.x(), box.lower.y()}, box.upper, {box.lower.x(), box.upper.y()}};
}

// A frame around all lines, cut along them: one block is what lies outside, with the rock in its hole.
CutRock cut_frame(const RockPlan& plan, const std::string& name, double tolerance) {
  RockPlan frame;
  frame.boundary = frame_around(plan);
  frame.boundary_origin = name;
  frame.lines = plan.lines;
  CutOptions options;
  options.tolerance = tolerance;
  return cut_rock(frame, options);
}

[[noreturn]] void refuse_as_enclosing_nothing(const std::string& name) {
  throw InputError("", name, "a drawing whose lines enclose nothing", "lines around blocks");
}

// Nothing of the frame is left where all of it is narrower than what counts as one place.
Ring outline_in(CutRock& frame, const Vec2& corner, const std::string& name, double reach) {
  const auto outside = std::ranges::find_if(
      frame.blocks, [&](const CutBlock& block) { return std::ranges::count(block.shape.outer, corner) > 0; });
  if (outside == frame.blocks.end())
    throw InputError("", name, smaller_than_one_place(reach),
                     "larger blocks, a tolerance, or no line far away from them");
  std::vector<Ring> outlines = std::move(outside->shape.holes);
  frame.blocks.erase(outside);
  if (outlines.empty()) refuse_as_enclosing_nothing(name);
  if (outlines.size() > 1)
    throw InputError("", name,
                     fmt::format("a drawing of {} pieces of rock apart, at {} and {}", outlines.size(),
                                 written(outlines[0].front()), written(outlines[1].front())),
                     "blocks that touch each other");
  std::ranges::reverse(outlines.front());
  return std::move(outlines.front());
}

// Without the corners that only joints made: cut again by these, sides that are straight but for round-off would leave
// slivers.
Ring without_flat_corners(const Ring& ring, double distance_allowed) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& before = kept.empty() ? ring.back() : kept.back();
    const Vec2& after = ring[(i + 1) % ring.size()];
    if (distance({before, after}, ring[i]) > distance_allowed) kept.push_back(ring[i]);
  }
  return kept;
}

// The block with the point inside, and none other in it.
PlanOpening opening_around(const PlanPoint& point, const std::vector<CutBlock>& blocks, double flat_below) {
  const auto found = std::ranges::find_if(
      blocks, [&](const CutBlock& block) { return locate(block.shape, point.at) == Location::inside; });
  if (found == blocks.end())
    throw InputError("", point.origin, "at " + written(point.at) + ", in no block", "a place inside a block");
  if (!found->shape.holes.empty())
    throw InputError("", point.origin, "at " + written(point.at) + ", in a block with others inside",
                     "a block whose outline is one closed line");
  return {point.name, without_flat_corners(found->shape.outer, flat_below), "", false, point.origin};
}

// Several points in one block take it out once.
void add_openings(const std::vector<PlanPoint>& points, const std::vector<CutBlock>& blocks, double flat_below,
                  RockPlan& plan) {
  for (const PlanPoint& point : points) {
    PlanOpening opening = opening_around(point, blocks, flat_below);
    const auto is_same = [&](const PlanOpening& other) { return other.outline == opening.outline; };
    if (std::ranges::none_of(plan.openings, is_same)) plan.openings.push_back(std::move(opening));
  }
}

bool lies_along(const PlanLine& line, const Ring& ring, double reach) {
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Segment part{line.points[i - 1], line.points[i]};
    double covered = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (const auto along = collinear_overlap(part, {ring[k], ring[(k + 1) % ring.size()]}, reach))
        covered += (along->second - along->first).norm();
    }
    if (covered < (part.end - part.start).norm() - 2 * reach) return false;
  }
  return true;
}

}  // namespace

void enclose_rock(const std::string& name, double reach, const std::vector<PlanPoint>& points, RockPlan& plan) {
  if (plan.lines.empty()) refuse_as_enclosing_nothing(name);
  CutRock frame = cut_frame(plan, name, reach);
  plan.boundary = without_flat_corners(outline_in(frame, frame_around(plan).front(), name, reach), flat * reach);
  plan.boundary_origin = name;
  add_openings(points, frame.blocks, flat * reach, plan);
  std::erase_if(plan.lines, [&](const PlanLine& line) { return lies_along(line, plan.boundary, reach); });
}

}  // namespace dda
