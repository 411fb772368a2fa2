// A block with so many corners that one looks only at what is near when two of them become one: rock between short
// joints can be a single block with thousands of islands in it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/cutting/corner_places.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/segment.h"

namespace dda {

// Two nodes have become `into`, at `position`; they were at `one` and `other`.
struct CornerMove {
  int into = 0;
  Vec2 position, one, other;

  // m, that a point of an edge there has gone at most.
  [[nodiscard]] double way() const { return std::max((position - one).norm(), (position - other).norm()); }
};

// Answers as defect() of the whole polygon does. What a few corners cannot change is not calculated again: a ring is
// not flat that holds three corners of a fat triangle; an area stays positive while it is larger than what edges swept
// over; islands stay where they are unless an edge came by. Where that does not settle it, the whole polygon is asked.
class LargeBlock {
 public:
  // Looks at the whole block as it is now. Both stay in use.
  LargeBlock(const NodeRings& rings, const CornerPlaces& places);

  // Whether the block is sound now. To be asked after every move of its corners; the one who asks may then undo it.
  [[nodiscard]] bool is_sound_after(const CornerMove& move);

  // How often the whole polygon was looked at.
  [[nodiscard]] int looked_at_whole() const { return looked_at_whole_; }

 private:
  // An edge as drawn, from its corner to the next one of the ring. Edges and corners go by their place among all of the
  // block.
  struct Edge {
    int ring = 0;
    int node = 0;  // where it begins, as drawn
  };
  // Corners of a ring that are in one place now, and the edges that lead to and from there.
  struct Run {
    int ring = 0;
    int in = 0, out = 0;
  };

  static std::vector<Edge> edges_of(const NodeRings& rings);
  [[nodiscard]] std::vector<Box> drawn_boxes() const;
  [[nodiscard]] bool is_sound_as_whole(double swept);

  [[nodiscard]] std::vector<int> near(const Box& box) const;
  [[nodiscard]] std::vector<int> corners_at(const CornerMove& move) const;
  [[nodiscard]] std::optional<Run> run_of(const std::vector<int>& corners) const;
  [[nodiscard]] bool repeats_corner(const Run& run, const CornerMove& move) const;
  [[nodiscard]] bool meets_edge(int edge) const;
  [[nodiscard]] bool conflict(int a, int b) const;

  [[nodiscard]] bool keeps_tolerance(const CornerMove& move);
  [[nodiscard]] bool is_fat(int ring) const;
  [[nodiscard]] bool passes_island(const Run& run, double way) const;
  [[nodiscard]] double swept_by(const Run& run, double way) const;
  [[nodiscard]] bool keeps_area() const;

  [[nodiscard]] int following(int edge) const;
  [[nodiscard]] int preceding(int edge) const;
  [[nodiscard]] int next_of_length(int edge) const;
  [[nodiscard]] int place(int edge) const { return places_.node(edges_[static_cast<std::size_t>(edge)].node); }
  [[nodiscard]] bool has_length(int edge) const { return place(edge) != place(following(edge)); }
  [[nodiscard]] Segment segment(int edge) const;
  [[nodiscard]] int ring(int edge) const { return edges_[static_cast<std::size_t>(edge)].ring; }

  const NodeRings& rings_;
  const CornerPlaces& places_;
  std::vector<Edge> edges_;
  std::vector<int> first_;           // by ring, the first of its edges; at the end, how many there are
  BoxIndex index_;                   // of edges as drawn
  std::vector<double> thickness_;    // m, by ring: of a triangle of three of its corners as drawn
  double largest_ = 0;               // coordinate of the outer ring, m
  double tolerance_ = 0;             // m, of things that touch
  double area_ = 0;                  // m2, when the whole was looked at
  double least_moment_ = 0;          // m4, of the second moments
  double diagonal_ = 0;              // m, of the box
  double swept_ = 0;                 // m2, by edges that moved since then
  bool is_looked_at_whole_ = false;  // always, as what follows from a sound block before a move does not hold
  int looked_at_whole_ = 0;
};

}  // namespace dda
