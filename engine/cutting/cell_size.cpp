#include "engine/cutting/cell_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"
#include "engine/geometry/triangulate.h"

namespace dda {
namespace {

constexpr double longest_side = 1;  // of a part, in sizes of a cell there
// A part holds 0.06 cells or more unless it is a sliver; beyond this there is something wrong with the size.
constexpr std::size_t most_parts = 4'000'000;

double distance_to(const Ring& ring, const Vec2& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, distance({ring[i], ring[(i + 1) % ring.size()]}, place));
  return least;
}

class Divider {
 public:
  explicit Divider(const PlanFill& fill) : fill_(fill) {}

  // Halves the longest side until it is short (Rivara 1984).
  void divide(const std::array<Vec2, 3>& corners) {
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) { return (corners[(i + 1) % 3] - corners[(i + 2) % 3]).norm(); };
    for (std::size_t i = 1; i < 3; ++i) {
      if (length(i) > length(longest)) longest = i;
    }
    const Vec2& apex = corners[longest];
    const Vec2& from = corners[(longest + 1) % 3];
    const Vec2& to = corners[(longest + 2) % 3];
    const double size = cell_size(fill_, (apex + from + to) / 3);
    if (length(longest) <= longest_side * size) return add(corners, size);
    const Vec2 middle = (from + to) / 2;
    divide({apex, from, middle});
    divide({apex, middle, to});
  }

  std::vector<FillPart> take() { return std::move(parts_); }

 private:
  void add(const std::array<Vec2, 3>& corners, double size) {
    const double area = cross(Vec2(corners[1] - corners[0]), Vec2(corners[2] - corners[0])) / 2;
    parts_.push_back({corners, size, area / (size * size)});
    cells_ += parts_.back().cells;
    if (cells_ > most_cells || parts_.size() > most_parts)
      throw InputError("", fill_.origin, fmt::format("more than {:.0f} cells in one block", most_cells),
                       "a larger size");
  }

  const PlanFill& fill_;
  std::vector<FillPart> parts_;
  double cells_ = 0;
};

}  // namespace

double cell_size(const PlanFill& fill, const Vec2& place) {
  double size = fill.size;
  for (const Ring& outline : fill.fine_at)
    size = std::min(size, fill.finest + fill.growth * distance_to(outline, place));
  return size;
}

std::vector<FillPart> parts_of(const Polygon& polygon, const PlanFill& fill) {
  std::vector<Vec2> vertices = polygon.outer;
  for (const Ring& hole : polygon.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
  const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
  if (!(area_moments(polygon).area < most_cells * fill.size * fill.size))
    throw InputError("", fill.origin, fmt::format("more than {:.0f} cells in one block", most_cells), "a larger size");
  Divider divider(fill);
  for (const auto& [a, b, c] : triangulate(polygon)) divider.divide({vertex(a), vertex(b), vertex(c)});
  return divider.take();
}

}  // namespace dda
