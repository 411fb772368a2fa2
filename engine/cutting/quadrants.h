// Which pieces come near each other, and which come near which nodes: the plane is divided into four, and each part
// into four again, until few things are left in a part. What is dense in one place and sparse in another costs no more
// than what is even. Pieces side by side, as the joints of one set, all come into a part however small it is: these are
// parted along the way they run.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/cutting/piece.h"

namespace dda {

// A square of the grid: pixels from `lower` on, `size` in either direction.
struct Quadrant {
  Pixel lower;
  std::int64_t size = 0;

  [[nodiscard]] bool holds(const Pixel& pixel) const {
    return pixel.x >= lower.x && pixel.y >= lower.y && pixel.x < lower.x + size && pixel.y < lower.y + size;
  }
};

// Calls `visit` with squares and pieces in each. Two pieces that cross come up together with the square that holds the
// pixel of their crossing. Squares are disjoint, but for those whose pieces run side by side: these come in crowds of
// neighbours, each with the same square.
void visit_crowds(const std::vector<Piece>& pieces,
                  const std::function<void(const Quadrant&, const std::vector<int>&)>& visit);

// Calls `visit` with pieces and nodes that lie close. Each node comes up once, with all pieces that enter its pixel or
// pass within `reach` steps of the grid.
void visit_meetings(const std::vector<Piece>& pieces, const std::vector<Pixel>& nodes, double reach,
                    const std::function<void(const std::vector<int>&, const std::vector<int>&)>& visit);

}  // namespace dda
