// Cutting segments where they meet: snap rounding (Hobby 1999; Guibas and Marimont 1998) on the pixels of a fine grid.
//
// The pixels of all ends and of all crossings are hot. Each segment becomes the chain of the hot pixels it enters, and
// goes straight from the middle of one to that of the next. Such chains never cross and meet only in their nodes;
// what comes out does not depend on the order of the segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "engine/cutting/piece.h"
#include "engine/cutting/pixel_region.h"

namespace dda {

// A straight line of the drawing, as given, in m; crossings are computed from these.
struct Straight {
  Vec2 from;
  Vec2 to;
};

// Part of a straight between two nodes, from < to.
struct Link {
  int from = 0;
  int to = 0;
  int straight = 0;
  bool operator==(const Link&) const = default;
};

inline bool operator<(const Link& a, const Link& b) {
  return std::tie(a.from, a.to, a.straight) < std::tie(b.from, b.to, b.straight);
}

// A place that keeps its bits, and the pixel that counts for it.
struct KnownNode {
  Pixel pixel;
  Vec2 position;
};

struct Noding {
  std::vector<Pixel> pixels;        // of the nodes, ascending
  std::vector<Vec2> positions;      // m, of the nodes; each in its pixel: an end as given, else the crossing
  std::vector<Link> links;          // ascending, each once
  std::vector<PixelBox> crowded;    // where nodes lie near others, or near a piece that does not enter them
  std::size_t pieces_noded = 0;     // how many pieces were compared with others, what that cost
  std::size_t pairs_looked_at = 0;  // of pieces and pieces, and of pieces and nodes, for that
  bool is_unfinished = false;       // welding used up its rounds: places nearer than round-off may be left
};

// `known` are the places of the drawing that nodes keep. Other ends of pieces get the middle of a pixel. What comes
// within `reach` steps of the grid is told as crowded.
Noding node_pieces(const std::vector<Piece>& pieces, const std::vector<Straight>& straights,
                   const std::vector<KnownNode>& known, const PixelGrid& grid, double reach);

// A link of a noding that was changed, with the nodes' numbers there.
struct ChangedLink {
  Link link;
  bool is_changed = false;  // since it was noded with the others
};

// What has to be noded again, and where.
struct Renoding {
  std::vector<Pixel> pixels;  // of the nodes
  std::vector<Vec2> positions;
  std::vector<bool> stays;         // by node; links lead to such nodes only
  std::vector<ChangedLink> links;  // ascending, each once
  std::vector<PixelBox> places;    // around links that changed, as they were and as they are
  std::int64_t reach = 0;          // pixels around these in which nodes may have moved
};

// The same as to node all links. Those that did not change only meet in their nodes: only what comes near `places` is
// compared with others.
Noding node_again(const Renoding& changed, const std::vector<Straight>& straights, const PixelGrid& grid);

}  // namespace dda
