#include "engine/cutting/edge_left_of.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

double x_at(const Pixel& low, const Pixel& high, std::int64_t y) {
  const double share = static_cast<double>(y - low.y) / static_cast<double>(high.y - low.y);
  return static_cast<double>(low.x) + share * static_cast<double>(high.x - low.x);
}

}  // namespace

EdgeLeftOf::EdgeLeftOf(std::span<const Pixel> pixels, std::span<const int> origins)
    : pixels_(pixels), origins_(origins) {
  if (edges() == 0) return;
  lower_ = pixels.front();
  Pixel upper = lower_;
  for (const Pixel& pixel : pixels) {
    lower_ = {std::min(lower_.x, pixel.x), std::min(lower_.y, pixel.y)};
    upper = {std::max(upper.x, pixel.x), std::max(upper.y, pixel.y)};
  }
  const double wide = static_cast<double>(upper.x - lower_.x) + 1;
  const double high = static_cast<double>(upper.y - lower_.y) + 1;
  const double count = edges();
  cell_ = static_cast<std::int64_t>(std::ceil(std::max(std::sqrt(wide * high / count), std::max(wide, high) / count)));
  columns_ = column_of(upper.x) + 1;
  rows_ = row_of(upper.y) + 1;
  starts_.assign(at(columns_ * rows_) + 1, 0);
  for (int edge = 0; edge < edges(); ++edge) visit_cells(edge, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  edges_.resize(at(starts_.back()));
  std::vector<int> fill(starts_.begin(), starts_.end() - 1);
  for (int edge = 0; edge < edges(); ++edge)
    visit_cells(edge, [&](std::size_t cell) { edges_[at(fill[cell]++)] = edge; });
}

const Pixel& EdgeLeftOf::start(int half_edge) const { return pixels_[at(origins_[at(half_edge)])]; }

std::int64_t EdgeLeftOf::column_of(std::int64_t x) const { return (x - lower_.x) / cell_; }
std::int64_t EdgeLeftOf::row_of(std::int64_t y) const { return (y - lower_.y) / cell_; }

// Row by row, the cells from where the edge comes into the row to where it leaves it. A level edge meets no ray.
template <typename Visit>
void EdgeLeftOf::visit_cells(int edge, Visit visit) const {
  Pixel low = start(2 * edge);
  Pixel high = start(2 * edge + 1);
  if (low.y == high.y) return;
  if (low.y > high.y) std::swap(low, high);
  const auto [left, right] = std::minmax(low.x, high.x);
  for (std::int64_t row = row_of(low.y); row <= row_of(high.y); ++row) {
    const std::int64_t from = std::max(low.y, lower_.y + row * cell_);
    const std::int64_t to = std::min(high.y, lower_.y + (row + 1) * cell_);
    const auto [a, b] = std::minmax({x_at(low, high, from), x_at(low, high, to)});
    const std::int64_t first = column_of(std::max(left, static_cast<std::int64_t>(std::floor(a)) - 1));
    const std::int64_t last = column_of(std::min(right, static_cast<std::int64_t>(std::ceil(b)) + 1));
    for (std::int64_t column = first; column <= last; ++column) visit(at(column * rows_ + row));
  }
}

// An edge has its lower end and not its upper one, as if the ray started a little higher: edges that share the place
// where they are met are told apart by their slopes.
void EdgeLeftOf::look(std::size_t cell, const Pixel& from, Hit& nearest) const {
  for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
    const int edge = edges_[at(i)];
    Pixel low = start(2 * edge);
    Pixel high = start(2 * edge + 1);
    if (low.y > high.y) std::swap(low, high);
    if (from.y < low.y || from.y >= high.y || turn(low, high, from) >= 0) continue;  // right of the ray
    const double slope = static_cast<double>(high.x - low.x) / static_cast<double>(high.y - low.y);
    const double x = x_at(low, high, from.y);
    if (nearest.edge < 0 || x > nearest.x || (x == nearest.x && slope > nearest.slope)) nearest = {edge, x, slope};
  }
}

int EdgeLeftOf::of(int node) const {
  const Pixel& from = pixels_[at(node)];
  const std::int64_t row = row_of(from.y);
  Hit nearest;
  for (std::int64_t column = column_of(from.x); column >= 0; --column) {
    look(at(column * rows_ + row), from, nearest);
    if (nearest.edge >= 0 && nearest.x >= static_cast<double>(lower_.x + column * cell_)) break;
  }
  if (nearest.edge < 0) return -1;
  const int half_edge = 2 * nearest.edge;
  const bool runs_down = start(half_edge).y > start(half_edge + 1).y;
  return runs_down ? half_edge : half_edge + 1;
}

}  // namespace dda
