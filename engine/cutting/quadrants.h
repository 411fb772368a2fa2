// Which pieces come near each other, and which come near which nodes: the plane is divided into four, and each part
// into four again, until few things are left in a part. What is dense in one place and sparse in another costs no more
// than what is even. Pieces side by side, as the joints of one set, all come into a part however small it is: these are
// parted along the way they run.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
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

// A piece with its number, so that what is near lies close together in memory too.
struct NearPiece {
  PixelSegment segment;
  int piece = 0;
};

struct NearNode {
  Pixel pixel;
  int node = 0;
};

// Threads share the work by parts of the plane, and what is found in a part is to be kept by it: then it is the same
// whatever the number of threads. Parts are numbered up to this.
inline constexpr std::size_t most_parts_of_plane = 256;

// Calls `visit` with squares and pieces in each. Two pieces that cross come up together with the square that holds the
// pixel of their crossing. Squares are disjoint, but for those whose pieces run side by side: these come in crowds of
// neighbours, each with the same square. The first argument is the part; parts are visited at once.
using VisitCrowd = std::function<void(std::size_t, const Quadrant&, std::span<const NearPiece>)>;
void visit_crowds(const std::vector<Piece>& pieces, const VisitCrowd& visit);

// Calls `visit` with pieces and nodes that lie close. Each node comes up once, with all pieces that enter its pixel or
// pass within `reach` steps of the grid. The first argument is the part; parts are visited at once.
using VisitMeeting = std::function<void(std::size_t, std::span<const NearPiece>, std::span<const NearNode>)>;
void visit_meetings(const std::vector<Piece>& pieces, const std::vector<Pixel>& nodes, double reach,
                    const VisitMeeting& visit);

// What was kept by part, as one list.
template <typename Found>
std::vector<Found> in_one_list(std::vector<std::vector<Found>>&& parts) {
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  std::vector<Found> all;
  all.reserve(size);
  for (auto& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
  return all;
}

}  // namespace dda
