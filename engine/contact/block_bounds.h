// Where blocks may go before a list of the pairs that can touch is to be made anew.
//
// Every block has an upright box. One that is slender and lies aslant fills little of it: bedding of 0.3 m that dips by
// 35 degrees, cut every 10 m, has twenty layers in the upright box of each of its blocks. Such a block has a box along
// itself as well, and is apart from another where either pair of boxes is.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/geometry/box.h"

namespace dda {

// A box with sides along a direction and across it, in coordinates of these.
struct SlantedBox {
  Vec2 along = Vec2::Zero();  // unit; zero: the upright box serves as well
  Box box;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [along, box] = self;
    archive(along, box);
  }
};

// The direction in which most of a block's outline runs, unit, and the box along it.
SlantedBox slanted_box(const Outlines& outlines, int block);

class BlockBounds {
 public:
  // As the blocks lie, each grown by its margin, m. Nothing holds, or touches, a block whose margin is negative.
  void set(const Outlines& outlines, std::span<const double> margins);

  // Whether the block as it lies now, grown by `margin` (m), is within its bounds.
  [[nodiscard]] bool hold(const Outlines& outlines, int block, double margin) const;

  // Pairs of blocks, the smaller number first, in ascending order, whose bounds overlap.
  [[nodiscard]] std::vector<std::pair<int, int>> overlapping() const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [upright, slanted] = self;
    archive.each(upright);
    archive.each(slanted);
  }

 private:
  [[nodiscard]] bool are_apart(int a, int b) const;
  [[nodiscard]] bool is_beside(const SlantedBox& one, int other) const;

  std::vector<Box> upright_;
  std::vector<SlantedBox> slanted_;
};

}  // namespace dda
