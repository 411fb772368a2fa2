#include "engine/cutting/given_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/core/error.h"
#include "engine/cutting/block_order.h"
#include "engine/cutting/materials.h"
#include "engine/geometry/box.h"
#include "engine/geometry/diameter.h"
#include "engine/geometry/near_shapes.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double default_tolerance = 1e-6;  // of the diameter, as when cutting

// What of a straight line an edge of a block runs along, as distances from its start.
struct Cover {
  double from = 0, to = 0;
  bool left = false;  // the block lies left of the line
};

std::vector<const Ring*> outlines_of(const std::vector<CutBlock>& blocks) {
  std::vector<const Ring*> outlines;
  for (const CutBlock& block : blocks) outlines.push_back(&block.shape.outer);
  return outlines;
}

class Edges {
 public:
  Edges(const std::vector<CutBlock>& blocks, double tolerance)
      : blocks_(blocks), tolerance_(tolerance), index_(outlines_of(blocks)) {}

  // Two blocks touch somewhere along the line.
  [[nodiscard]] bool are_on_both_sides(const std::vector<Cover>& covers) const {
    double left = 0, right = 0;  // how far the edges looked at so far go, on each side
    for (const Cover& cover : covers) {
      double& own = cover.left ? left : right;
      const double other = cover.left ? right : left;
      if (std::min(cover.to, other) - cover.from > tolerance_) return true;
      own = std::max(own, cover.to);
    }
    return false;
  }

  // Sorted by where they begin.
  [[nodiscard]] std::vector<Cover> along(const Segment& line) const {
    std::vector<Cover> covers;
    for (const int i : index_.near(line, tolerance_)) {
      const Polygon& shape = blocks_[static_cast<std::size_t>(i)].shape;
      add_covers(shape.outer, line, covers);
      for (const Ring& hole : shape.holes) add_covers(hole, line, covers);
    }
    std::ranges::sort(covers, {}, &Cover::from);
    return covers;
  }

  void refuse_inside(const PlanLine& line, const Segment& part, const std::vector<Cover>& covers) const {
    double reached = 0;
    const double length = (part.end - part.start).norm();
    const auto look_between = [&](double from, double to) {
      if (to - from > 2 * tolerance_) refuse_in_block(line, point_at(part, (from + to) / (2 * length)));
    };
    for (const Cover& cover : covers) {
      look_between(reached, cover.from);
      reached = std::max(reached, cover.to);
    }
    look_between(reached, length);
  }

 private:
  void add_covers(const Ring& ring, const Segment& line, std::vector<Cover>& covers) const {
    const Vec2 direction = (line.end - line.start).normalized();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment edge{ring[i], ring[(i + 1) % ring.size()]};
      const auto common = collinear_overlap(line, edge, tolerance_);
      if (!common) continue;
      covers.push_back({direction.dot(common->first - line.start), direction.dot(common->second - line.start),
                        direction.dot(edge.end - edge.start) > 0});
    }
  }

  void refuse_in_block(const PlanLine& line, const Vec2& point) const {
    for (const int i : index_.near(Box{point, point})) {
      if (locate(blocks_[static_cast<std::size_t>(i)].shape, point, tolerance_) == Location::inside)
        throw InputError("", line.origin, "at " + written(point) + " inside a block",
                         "a line along edges of blocks; those of a drawing of blocks are not cut again");
    }
  }

  const std::vector<CutBlock>& blocks_;
  double tolerance_;
  ShapeIndex index_;
};

void add_joints(const RockPlan& plan, CutRock& rock) {
  const Edges edges(rock.blocks, rock.tolerance);
  for (const PlanLine& line : plan.lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Segment part{line.points[i - 1], line.points[i]};
      const double length = (part.end - part.start).norm();
      const std::vector<Cover> covers = length > 0 ? edges.along(part) : std::vector<Cover>{};
      if (length > 0) edges.refuse_inside(line, part, covers);
      if (edges.are_on_both_sides(covers))
        rock.joints.push_back({part.start, part.end, line.joint});
      else
        rock.cleaned.push_back({length > 0 ? Cleaning::line_not_used : Cleaning::line_without_length, part.start,
                                part.end, length, line.origin});
    }
  }
}

double tolerance_for(const std::vector<CutBlock>& blocks, double wanted) {
  if (wanted > 0) return wanted;
  std::vector<Vec2> corners;
  for (const CutBlock& block : blocks)
    corners.insert(corners.end(), block.shape.outer.begin(), block.shape.outer.end());
  return default_tolerance * diameter(std::move(corners));
}

}  // namespace

CutRock given_rock(const RockPlan& plan, double tolerance) {
  CutRock rock;
  rock.cleaned = plan.cleaned;
  for (const PlanBlock& block : plan.blocks) {
    if (const auto why = defect(block.shape)) throw InputError("", block.origin, *why, "the outline of a block");
    rock.blocks.push_back({normalized(block.shape), -1, block.material, block.group});
    rock.boundary_area += area_moments(rock.blocks.back().shape).area;
  }
  put_in_order(rock.blocks);
  rock.tolerance = tolerance_for(rock.blocks, tolerance);
  add_joints(plan, rock);
  assign_materials(plan, rock);
  return rock;
}

}  // namespace dda
