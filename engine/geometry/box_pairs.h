// Broad phase: which boxes overlap.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/box.h"

namespace dda {

// All pairs (i, j), i < j, of boxes that overlap or touch, each once, in ascending order. Empty boxes overlap nothing;
// the corners of the others must be finite. About linear in the number of boxes plus pairs, whatever the mix of sizes:
// every box lies in one cell of a uniform grid with cells of about its own size (spatial hashing on levels).
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes);

// Answers which of many boxes overlap or touch a given one without looking at all of them.
class BoxIndex {
 public:
  explicit BoxIndex(std::vector<Box> boxes);
  ~BoxIndex();

  // Indices in ascending order. About as much work as there are answers, where the box is no larger than they are.
  [[nodiscard]] std::vector<int> overlapping(const Box& box) const;

 private:
  struct Levels;
  std::unique_ptr<const Levels> levels_;
};

}  // namespace dda
