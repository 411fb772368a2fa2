// Broad phase for shapes that are long, thin and oblique, as the blocks between joints of one set: their boxes all
// overlap where the shapes lie side by side.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/box_pairs.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {

// Which of many shapes come near a box. Where the boxes of shapes tell them apart it asks these, else a tree of
// rectangles, each turned the way of the longest shape in it. Shapes are given by their outer rings.
class ShapeIndex {
 public:
  explicit ShapeIndex(std::span<const Ring* const> shapes);
  ~ShapeIndex();

  // In ascending order: all that have a point in `box`, and of the others some whose boxes overlap it.
  [[nodiscard]] std::vector<int> near(const Box& box) const;

  // The same of a line: all that have a point within `reach` (m) of it.
  [[nodiscard]] std::vector<int> near(const Segment& line, double reach) const;

 private:
  struct Tree;
  template <typename Rectangle>
  [[nodiscard]] std::vector<int> in_tree(const Rectangle& rectangle, const Box& box) const;

  std::vector<Box> boxes_;
  std::unique_ptr<const BoxIndex> grid_;  // one of the two
  std::unique_ptr<const Tree> tree_;
};

// Pairs (i, j), i < j, in ascending order, of shapes whose boxes[i] and boxes[j] overlap or touch: all pairs with a
// common point in both boxes, and of the others some.
std::vector<std::pair<int, int>> pairs_of_near_shapes(std::span<const Ring* const> shapes, std::span<const Box> boxes);

}  // namespace dda
