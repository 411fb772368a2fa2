#include "engine/cutting/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"
#include "engine/geometry/triangulate.h"

namespace dda {
namespace {

std::string remark_without_blocks(const PlanRegion& region) {
  return fmt::format(
      "{} has the middle of no block in it, so it gives \"{}\" to none: it lies beside the rock, or is smaller than "
      "its "
      "blocks, which have one material each",
      region.origin, region.material);
}

}  // namespace

Vec2 point_inside(const Polygon& polygon) {
  Vec2 centroid = area_moments(polygon).centroid;
  if (locate(polygon, centroid) == Location::inside) return centroid;
  std::vector<Vec2> vertices = polygon.outer;
  for (const Ring& hole : polygon.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
  const auto corner = [&](const Triangle& triangle, std::size_t i) -> const Vec2& {
    return vertices[static_cast<std::size_t>(triangle.at(i))];
  };
  const auto area = [&](const Triangle& t) {
    return cross(Vec2(corner(t, 1) - corner(t, 0)), Vec2(corner(t, 2) - corner(t, 0)));
  };
  const auto triangles = triangulate(polygon);
  const Triangle& largest = *std::max_element(triangles.begin(), triangles.end(),
                                              [&](const Triangle& a, const Triangle& b) { return area(a) < area(b); });
  return (corner(largest, 0) + corner(largest, 1) + corner(largest, 2)) / 3;
}

void assign_materials(const RockPlan& plan, CutRock& rock) {
  std::vector<Box> boxes;
  for (const PlanRegion& region : plan.regions) boxes.push_back(bounding_box(region.outline));
  std::vector<bool> holds_blocks(plan.regions.size());
  for (CutBlock& block : rock.blocks) {
    if (block.material.empty()) block.material = plan.material;
    if (plan.regions.empty()) continue;
    const Vec2 inside = point_inside(block.shape);
    for (std::size_t i = 0; i < plan.regions.size(); ++i) {
      if (!overlap(boxes[i], Box{inside, inside}) || !contains({plan.regions[i].outline, {}}, inside)) continue;
      block.material = plan.regions[i].material;
      holds_blocks[i] = true;
    }
  }
  for (std::size_t i = 0; i < plan.regions.size(); ++i)
    if (!holds_blocks[i]) rock.remarks.push_back(remark_without_blocks(plan.regions[i]));
}

}  // namespace dda
