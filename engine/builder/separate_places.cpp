#include "engine/builder/separate_places.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "engine/builder/free_outline.h"
#include "engine/core/disjoint_sets.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/triangulate.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool touch_along_a_face(const Block& a, const Block& b, double tolerance) {
  const std::vector<Segment> others = edges_of(b.shape);
  for (const Segment& edge : edges_of(a.shape))
    for (const Segment& other : others)
      if (collinear_overlap(edge, other, tolerance)) return true;
  return false;
}

void join_touching(const std::vector<bool>& away, const Model& model, DisjointSets& sets) {
  const double tolerance = point_tolerance(model);
  std::vector<int> blocks;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (!away[i]) continue;
    blocks.push_back(static_cast<int>(i));
    boxes.push_back(expanded(bounding_box(model.blocks[i].shape), tolerance));
  }
  for (const auto& [a, b] : overlapping_pairs(boxes))
    if (touch_along_a_face(model.blocks[at(blocks[at(a)])], model.blocks[at(blocks[at(b)])], tolerance))
      sets.join(blocks[at(a)], blocks[at(b)]);
}

Model without(const std::vector<bool>& away, const Model& model) {
  Model rest;
  rest.length_tolerance = model.length_tolerance;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (!away[i]) rest.blocks.push_back(model.blocks[i]);
  return rest;
}

// The middle of its largest triangle, which is inside whatever its shape.
Vec2 point_inside(const Polygon& shape) {
  std::vector<Vec2> corners = shape.outer;
  for (const Ring& hole : shape.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  double largest = -1;
  Vec2 middle = corners.front();
  for (const auto& [a, b, c] : triangulate(shape)) {
    const double area = cross(corners[at(b)] - corners[at(a)], corners[at(c)] - corners[at(a)]);
    if (area <= largest) continue;
    largest = area;
    middle = (corners[at(a)] + corners[at(b)] + corners[at(c)]) / 3;
  }
  return middle;
}

void join_within_a_wall(const std::vector<std::vector<int>>& places, const std::vector<bool>& away, const Model& model,
                        DisjointSets& sets) {
  const Model rest = without(away, model);
  const std::vector<FreeRing> rings = free_rings(rest);
  std::map<std::pair<double, double>, int> first_within;  // by where the ring begins
  for (const std::vector<int>& place : places) {
    const int block = place.front();
    const FreeRing wall = ring_around(rings, point_inside(model.blocks[at(block)].shape));
    if (wall.empty()) continue;
    const auto start = std::pair(wall.front().from.x(), wall.front().from.y());
    const auto [known, is_new] = first_within.emplace(start, block);
    if (!is_new) sets.join(known->second, block);
  }
}

std::vector<std::vector<int>> listed(const std::vector<int>& opening, DisjointSets& sets) {
  std::map<int, std::vector<int>> places;
  for (const int block : opening) places[sets.root(block)].push_back(block);
  std::vector<std::vector<int>> list;
  for (auto& [first, blocks] : places) list.push_back(std::move(blocks));
  std::ranges::sort(list);
  return list;
}

}  // namespace

std::vector<std::vector<int>> separate_places(const std::vector<int>& opening, const std::vector<bool>& away,
                                              const Model& model) {
  DisjointSets sets(model.blocks.size());
  join_touching(away, model, sets);
  std::vector<std::vector<int>> places = listed(opening, sets);
  if (places.size() < 2) return places;
  join_within_a_wall(places, away, model, sets);
  return listed(opening, sets);
}

std::string in_several_places(const std::string& name, const std::vector<std::vector<int>>& places,
                              const Model& model) {
  const auto first_of = [&](std::size_t place) { return "\"" + model.blocks[at(places[place].front())].name + "\""; };
  return "\"" + name + "\", whose blocks lie in " + std::to_string(places.size()) + " places, at " + first_of(0) +
         " and " + first_of(1) + (places.size() > 2 ? " and elsewhere" : "");
}

}  // namespace dda
