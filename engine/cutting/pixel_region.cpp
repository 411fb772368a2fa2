#include "engine/cutting/pixel_region.h"

#include <algorithm>
#include <cstddef>

namespace dda {

PixelBox box_of(const PixelSegment& segment) {
  const auto [left, right] = std::minmax(segment.from.x, segment.to.x);
  const auto [low, high] = std::minmax(segment.from.y, segment.to.y);
  return {{left, low}, {right, high}};
}

// A box adds one at its lower corner, and takes it back beyond its other corners: sums over all that is left of a cell
// and below are then the number of boxes on the cell. Sums of the cells on which there are any answer `meets`.
PixelRegion::PixelRegion(const std::vector<Pixel>& places, const std::vector<PixelBox>& boxes, std::int64_t reach) {
  if (places.empty()) {
    sums_.assign(4, 0);
    return;
  }
  lower_ = places.front();
  Pixel upper = lower_;
  for (const Pixel& place : places) {
    lower_ = {std::min(lower_.x, place.x), std::min(lower_.y, place.y)};
    upper = {std::max(upper.x, place.x), std::max(upper.y, place.y)};
  }
  const auto cells = [&](std::int64_t extent) { return (extent >> cell_exponent_) + 1; };
  const auto most = static_cast<std::int64_t>(places.size());
  while (cells(upper.x - lower_.x) > most / cells(upper.y - lower_.y) + 1) ++cell_exponent_;
  columns_ = cells(upper.x - lower_.x);
  rows_ = cells(upper.y - lower_.y);
  sums_.assign(index(0, rows_ + 1), 0);
  for (const PixelBox& box : boxes) {
    const Range range =
        range_of({{box.lower.x - reach, box.lower.y - reach}, {box.upper.x + reach, box.upper.y + reach}});
    ++sums_[index(range.left, range.low)];
    --sums_[index(range.right + 1, range.low)];
    --sums_[index(range.left, range.high + 1)];
    ++sums_[index(range.right + 1, range.high + 1)];
  }
  sum_up();
  // From numbers of boxes on cells to sums of cells, by corner.
  for (std::int64_t row = rows_; row > 0; --row) {
    for (std::int64_t column = columns_; column > 0; --column)
      sums_[index(column, row)] = sums_[index(column - 1, row - 1)] > 0 ? 1 : 0;
  }
  for (std::int64_t column = 0; column <= columns_; ++column) sums_[index(column, 0)] = 0;
  for (std::int64_t row = 0; row <= rows_; ++row) sums_[index(0, row)] = 0;
  sum_up();
}

void PixelRegion::sum_up() {
  for (std::int64_t row = 0; row <= rows_; ++row) {
    for (std::int64_t column = 1; column <= columns_; ++column)
      sums_[index(column, row)] += sums_[index(column - 1, row)];
  }
  for (std::int64_t row = 1; row <= rows_; ++row) {
    for (std::int64_t column = 0; column <= columns_; ++column)
      sums_[index(column, row)] += sums_[index(column, row - 1)];
  }
}

PixelRegion::Range PixelRegion::range_of(const PixelBox& box) const {
  const auto column = [&](std::int64_t x) {
    return std::clamp((x - lower_.x) >> cell_exponent_, std::int64_t{0}, columns_ - 1);
  };
  const auto row = [&](std::int64_t y) {
    return std::clamp((y - lower_.y) >> cell_exponent_, std::int64_t{0}, rows_ - 1);
  };
  return {column(box.lower.x), row(box.lower.y), column(box.upper.x), row(box.upper.y)};
}

bool PixelRegion::meets(const PixelBox& box) const {
  const Range range = range_of(box);
  return sums_[index(range.right + 1, range.high + 1)] - sums_[index(range.left, range.high + 1)] -
             sums_[index(range.right + 1, range.low)] + sums_[index(range.left, range.low)] >
         0;
}

}  // namespace dda
