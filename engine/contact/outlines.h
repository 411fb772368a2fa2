// Vertices of all blocks in one array, where they are now.
#pragma once

#include <vector>

#include "engine/core/types.h"
#include "engine/geometry/box.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// Vertex i of a block belongs to one of its rings (outer counter-clockwise, holes clockwise); edge i runs from vertex i
// to its successor, with the block on its left.
struct Outlines {
  std::vector<int> starts;      // block -> first of its vertices; one more entry than blocks
  std::vector<Vec2> reference;  // offsets from the block's reference centroid, m
  std::vector<int> next, previous;
  std::vector<Vec2> current;   // local positions (engine/model/state.h), m
  std::vector<double> length;  // of the edges, m
  std::vector<Vec2> coming;    // displacements foreseen for the step, m; zero where none are
  std::vector<Box> boxes;      // of each block's current outline

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [starts, reference, next, previous, current, length, coming, boxes] = self;
    // The others are the drawing's. These are of the last search, which a step may be judged by that makes none.
    archive.each(current);
    archive.each(length);
    archive.each(coming);
    archive.each(boxes);
  }

  [[nodiscard]] int blocks() const { return static_cast<int>(boxes.size()); }

  // From the start of an edge to its end, m.
  [[nodiscard]] Vec2 along(int edge) const {
    const auto first = static_cast<std::size_t>(edge);
    return current[static_cast<std::size_t>(next[first])] - current[first];
  }

  [[nodiscard]] double length_of(int edge) const { return length[static_cast<std::size_t>(edge)]; }
};

Outlines make_outlines(const Model& model, const State& state);

void update_outlines(const Model& model, const State& state, Outlines& outlines);

// Foresees what the velocities of `state` make of `time` (s), to first order.
void foresee_motion(const Model& model, const State& state, double time, Outlines& outlines);

}  // namespace dda
