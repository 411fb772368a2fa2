// Where the cells of a fill have their sites: drawn by lot, then moved apart.
#pragma once

#include <vector>

#include "engine/cutting/delaunay.h"
#include "engine/cutting/random_stream.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// Places in the box around a block as pixels that Delaunay takes, and back.
class SiteGrid {
 public:
  explicit SiteGrid(const Box& box);

  [[nodiscard]] Pixel pixel_of(const Vec2& place) const;
  [[nodiscard]] Vec2 place_of(const Vec2& steps) const { return middle_ + step_ * steps; }

 private:
  Vec2 middle_;
  double step_;  // m
};

// As many sites as cells of the asked size have room in the block; none when that are fewer than 2. They are dense
// where cells are small.
//
// Sites are moved to the centroids of their cells (Lloyd 1982), weighted so that cells keep the asked sizes, as often
// as the fill asks. Cells are known here by samples in the block: each belongs to the site nearest to it. So the
// block's own outline bounds cells, whatever its shape.
std::vector<Pixel> sites_of(const Polygon& block, const PlanFill& fill, const SiteGrid& grid, RandomStream& random);

}  // namespace dda
