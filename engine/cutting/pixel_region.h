// A part of the grid, as the cells of a coarse raster that some boxes reach into.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/cutting/pixel.h"

namespace dda {

// A box of pixels, its sides included.
struct PixelBox {
  Pixel lower;
  Pixel upper;
};

PixelBox box_of(const PixelSegment& segment);

class PixelRegion {
 public:
  // About one cell for each of `places`, over the extent of these. Boxes are widened by `reach` on all sides.
  PixelRegion(const std::vector<Pixel>& places, const std::vector<PixelBox>& boxes, std::int64_t reach);

  // Whether any cell of the region is near the box; never false for a box that meets a widened one.
  [[nodiscard]] bool meets(const PixelBox& box) const;

 private:
  // A rectangle of cells; the last ones are part of it.
  struct Range {
    std::int64_t left = 0, low = 0, right = 0, high = 0;
  };

  [[nodiscard]] Range range_of(const PixelBox& box) const;
  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * (columns_ + 1) + column);
  }
  void sum_up();

  Pixel lower_;
  int cell_exponent_ = 0;  // a cell has 2^cell_exponent_ pixels a side
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<int> sums_;  // by corner of cells: cells of the region left of it and below
};

}  // namespace dda
