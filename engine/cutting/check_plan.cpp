#include "engine/cutting/check_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "engine/core/error.h"

namespace dda {
namespace {

constexpr double farthest = 1e12;  // m, as for polygons

void check_polygon(const Polygon& polygon, const std::string& origin) {
  if (const auto why = defect(polygon)) throw InputError("", origin, *why, "a closed line that does not meet itself");
}

void check_line(const PlanLine& line) {
  if (line.points.size() < 2) throw InputError("", line.origin, "a line of fewer than two points", "two or more");
  for (const Vec2& point : line.points) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > farthest)
      throw InputError("", line.origin, "through " + written(point), "finite coordinates up to 1e12 m");
  }
}

// Its outline runs outside of the rock: then it holds either nothing of it, or all.
[[noreturn]] void refuse_without_outline_in_rock(const PlanOpening& opening, const RockPlan& plan) {
  const Polygon shape{opening.outline, {}};
  if (contains(shape, plan.boundary.front()))
    throw InputError("", opening.origin, fmt::format("\"{}\" around all of the rock", opening.name),
                     "an opening that leaves some of it");
  throw InputError(
      "", opening.origin,
      fmt::format("\"{}\" around {}, outside the rock", opening.name, written(area_moments(shape).centroid)),
      "an opening inside the boundary");
}

}  // namespace

void check_plan(const RockPlan& plan) {
  check_polygon({plan.boundary, {}}, plan.boundary_origin);
  for (std::size_t i = 0; i < plan.holes.size(); ++i)
    check_polygon({plan.holes[i], {}}, fmt::format("{}, hole {},", plan.boundary_origin, i + 1));
  check_polygon({plan.boundary, plan.holes}, plan.boundary_origin + " with its holes");
  for (const PlanOpening& opening : plan.openings) check_polygon({opening.outline, {}}, opening.origin);
  for (const PlanRegion& region : plan.regions) check_polygon({region.outline, {}}, region.origin);
  for (const PlanFill& fill : plan.fills) {
    if (!fill.region.empty()) check_polygon({fill.region, {}}, fill.origin + ".region");
  }
  for (const PlanLine& line : plan.lines) check_line(line);
}

void check_openings(const Arrangement& arrangement, const std::vector<FacePlace>& places, const PlanPieces& pieces,
                    const RockPlan& plan) {
  std::vector<bool> in_rock(plan.openings.size(), false);
  const auto in_boundary = [&](int half_edge) {
    return places[static_cast<std::size_t>(arrangement.face(half_edge))].in_boundary;
  };
  for (int edge = 0; edge < arrangement.edges(); ++edge) {
    if (!in_boundary(2 * edge) && !in_boundary(2 * edge + 1)) continue;
    for (const int straight : arrangement.straights(edge)) {
      const int opening = pieces.sources[static_cast<std::size_t>(straight)].curve - curve_of_opening(plan, 0);
      if (opening >= 0) in_rock[static_cast<std::size_t>(opening)] = true;
    }
  }
  const auto outside = std::find(in_rock.begin(), in_rock.end(), false);
  if (outside == in_rock.end()) return;
  refuse_without_outline_in_rock(plan.openings[static_cast<std::size_t>(outside - in_rock.begin())], plan);
}

}  // namespace dda
