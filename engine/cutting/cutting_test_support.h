// What the tests of this folder share: plans, and a check of cut rock that knows nothing of how it was cut.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/cutting/cut_rock.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/overlap.h"
#include "engine/geometry/segment.h"

namespace dda {

inline RockPlan square_plan(double size = 10) {
  RockPlan plan;
  plan.boundary = {{0, 0}, {size, 0}, {size, size}, {0, size}};
  plan.boundary_origin = "boundary";
  return plan;
}

inline void add_line(RockPlan& plan, std::vector<Vec2> points, std::string joint = "joint") {
  plan.lines.push_back({std::move(points), std::move(joint), "line " + std::to_string(plan.lines.size() + 1), false});
}

inline double total_area(const CutRock& rock) {
  double area = 0;
  for (const CutBlock& block : rock.blocks) area += area_moments(block.shape).area;
  return area;
}

inline int count(const CutRock& rock, Cleaning what) {
  return static_cast<int>(
      std::count_if(rock.cleaned.begin(), rock.cleaned.end(), [&](const Cleaned& c) { return c.what == what; }));
}

// Corners by their bits.
using Place = std::pair<double, double>;
inline Place place(const Vec2& point) { return {point.x(), point.y()}; }

template <typename Visit>
void for_each_edge(const Polygon& shape, Visit visit) {
  const auto ring = [&](const Ring& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) visit(vertices[i], vertices[(i + 1) % vertices.size()]);
  };
  ring(shape.outer);
  for (const Ring& hole : shape.holes) ring(hole);
}

// Every edge is shared with one neighbour, which has it the other way round with the same bits, or lies on the border
// of the rock; blocks minus edges plus corners is as Euler says.
struct Topology {
  std::map<std::pair<Place, Place>, int> edges;  // directed
  std::set<Place> corners;
  std::size_t shared = 0;  // undirected
  std::size_t single = 0;
  std::size_t holes = 0;
};

inline Topology topology_of(const CutRock& rock) {
  Topology topology;
  for (const CutBlock& block : rock.blocks) {
    topology.holes += block.shape.holes.size();
    for_each_edge(block.shape, [&](const Vec2& a, const Vec2& b) {
      ++topology.edges[{place(a), place(b)}];
      topology.corners.insert(place(a));
    });
  }
  for (const auto& [edge, times] : topology.edges) {
    EXPECT_EQ(times, 1) << "an edge is used twice in the same direction";
    if (topology.edges.count({edge.second, edge.first}) == 0)
      ++topology.single;
    else if (edge.first < edge.second)
      ++topology.shared;
  }
  return topology;
}

// Area of the border of the rock, from the edges that no two blocks share.
inline double border_area(const Topology& topology) {
  double area = 0;
  for (const auto& [edge, times] : topology.edges) {
    if (topology.edges.count({edge.second, edge.first}) == 0)
      area += cross(Vec2(edge.first.first, edge.first.second), Vec2(edge.second.first, edge.second.second)) / 2;
  }
  return area;
}

inline int blocks_around(const CutRock& rock, const Vec2& point) {
  return static_cast<int>(std::count_if(rock.blocks.begin(), rock.blocks.end(), [&](const CutBlock& block) {
    return locate(block.shape, point) == Location::inside;
  }));
}

// The blocks are simple polygons which fill the boundary and do not overlap.
inline void expect_sound(const CutRock& rock, const RockPlan& plan) {
  for (const CutBlock& block : rock.blocks) {
    const auto why = defect(block.shape);
    EXPECT_FALSE(why.has_value()) << *why;
    EXPECT_GT(signed_area(block.shape.outer), 0);
  }
  const double expected = rock.boundary_area - rock.left_out_area - rock.dropped_area;
  EXPECT_NEAR(total_area(rock), expected, 1e-12 * rock.boundary_area);
  EXPECT_NEAR(border_area(topology_of(rock)), expected, 1e-11 * rock.boundary_area);
  std::mt19937_64 random(7);
  const Box box = bounding_box(plan.boundary);
  for (int i = 0; i < 100; ++i) {
    const Vec2 share(std::uniform_real_distribution<double>(0, 1)(random),
                     std::uniform_real_distribution<double>(0, 1)(random));
    const Vec2 point = box.lower + share.cwiseProduct(box.upper - box.lower);
    const bool in_rock = contains({plan.boundary, plan.holes}, point);
    EXPECT_EQ(blocks_around(rock, point), in_rock ? 1 : 0) << point.transpose();
  }
}

// What a block is, whatever its name: area and centroid.
using Signature = std::tuple<double, double, double>;

inline std::vector<Signature> signatures_of(const CutRock& rock) {
  std::vector<Signature> found;
  for (const CutBlock& block : rock.blocks) {
    const AreaMoments moments = area_moments(block.shape);
    found.emplace_back(moments.area, moments.centroid.x(), moments.centroid.y());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Lots {
 public:
  explicit Lots(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Vec2 point(double low, double high) { return {between(low, high), between(low, high)}; }
  std::mt19937_64& bits() { return random_; }

 private:
  std::mt19937_64 random_;
};

inline void expect_no_overlap(const CutRock& rock, double tolerance) {
  std::vector<Box> boxes;
  for (const CutBlock& block : rock.blocks) boxes.push_back(bounding_box(block.shape));
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    EXPECT_FALSE(interiors_overlap(rock.blocks[static_cast<std::size_t>(a)].shape,
                                   rock.blocks[static_cast<std::size_t>(b)].shape, tolerance));
  }
}

// Connected parts of what the corners and edges make, by walking over them.
inline std::size_t parts_of(const Topology& topology) {
  std::map<Place, std::vector<Place>> neighbours;
  for (const auto& [edge, times] : topology.edges) {
    neighbours[edge.first].push_back(edge.second);
    neighbours[edge.second].push_back(edge.first);
  }
  std::set<Place> seen;
  std::size_t parts = 0;
  for (const Place& start : topology.corners) {
    if (!seen.insert(start).second) continue;
    ++parts;
    std::vector<Place> to_do{start};
    while (!to_do.empty()) {
      const Place at = to_do.back();
      to_do.pop_back();
      for (const Place& next : neighbours[at]) {
        if (seen.insert(next).second) to_do.push_back(next);
      }
    }
  }
  return parts;
}

// corners - edges + faces = 1 + parts, the outside being a face, and `empty` those that are left out.
inline void expect_euler(const CutRock& rock, std::size_t empty = 0) {
  const Topology topology = topology_of(rock);
  const std::size_t edges = topology.shared + topology.single;
  EXPECT_EQ(topology.corners.size() + rock.blocks.size() + empty + 1, edges + 1 + parts_of(topology));
}

}  // namespace dda
