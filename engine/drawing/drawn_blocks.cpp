#include "engine/drawing/drawn_blocks.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/error.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

// The number of a block; that of all where none has the hole.
std::size_t block_around(const DrawnRing& hole, const std::vector<DrawnRing>& outlines, const BoxIndex& index) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t found = outlines.size();
  const Vec2& corner = hole.ring.front();
  for (const int i : index.overlapping(Box{corner, corner})) {
    const DrawnRing& outline = outlines[static_cast<std::size_t>(i)];
    const double area = std::abs(signed_area(outline.ring));
    if (outline.group != hole.group || area >= least) continue;
    if (locate({outline.ring, {}}, corner) != Location::inside) continue;
    least = area;
    found = static_cast<std::size_t>(i);
  }
  return found;
}

}  // namespace

Ring closed_ring(std::vector<Vec2> points, const std::string& origin, double reach, std::vector<Cleaned>& cleaned) {
  const double gap = (points.front() - points.back()).norm();
  if (gap > reach)
    throw InputError("", origin, fmt::format("open, with ends {:.4g} m apart", gap),
                     "the outline of a block, closed in itself");
  if (gap > 0) cleaned.push_back({Cleaning::gap_closed, points.back(), points.front(), gap, origin});
  points.pop_back();
  return points;
}

std::vector<PlanBlock> blocks_with_holes(std::vector<DrawnRing> outlines, std::vector<DrawnRing> holes) {
  std::vector<Box> boxes;
  for (const DrawnRing& outline : outlines) boxes.push_back(bounding_box(outline.ring));
  const BoxIndex index(std::move(boxes));
  std::vector<std::vector<Ring>> holes_of(outlines.size());
  for (DrawnRing& hole : holes) {
    const std::size_t block = block_around(hole, outlines, index);
    if (block == outlines.size())
      throw InputError("", hole.origin, "in no block of group \"" + hole.group + "\"", "a hole inside of one");
    holes_of[block].push_back(std::move(hole.ring));
  }
  std::vector<PlanBlock> blocks;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    DrawnRing& outline = outlines[i];
    blocks.push_back({{std::move(outline.ring), std::move(holes_of[i])},
                      std::move(outline.group),
                      std::move(outline.material),
                      std::move(outline.origin)});
  }
  return blocks;
}

}  // namespace dda
