// Whether two polygons occupy the same ground.
#pragma once

#include <memory>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

// True when some point common to both polygons lies deeper than `tolerance` (m) in one of them, that is farther than
// that from its boundary. So polygons that touch, or whose edges were rounded apart or into each other by less, do not
// overlap, and neither does a block in the hole of another; identical polygons and one within the other do. Where two
// boundaries coincide, common parts narrower than five tolerances are not seen. Both must be valid
// (defect()), of either orientation; `tolerance` must be positive and well above the round-off of the coordinates.
bool interiors_overlap(const Polygon& a, const Polygon& b, double tolerance);

// The same of many pairs of some polygons, which must outlive it. Those with many edges are made ready beforehand, with
// an index of their edges: a large block with thousands of small neighbours takes time that goes with their number.
class Overlaps {
 public:
  explicit Overlaps(std::vector<const Polygon*> polygons);
  ~Overlaps();

  // May be asked by several threads at once.
  [[nodiscard]] bool between(int a, int b, double tolerance) const;

 private:
  struct Indexed;

  std::vector<const Polygon*> polygons_;
  std::vector<std::unique_ptr<const Indexed>> indexed_;  // of each with many edges
};

}  // namespace dda
