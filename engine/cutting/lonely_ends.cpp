#include "engine/cutting/lonely_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/cutting/quadrants.h"
#include "engine/geometry/box.h"

namespace dda {
namespace {

// How near another line counts, in tolerances: an end and the other line are both prolonged by one, and welding, whose
// rounds move places by a hundredth each, has as much room for either of them.
constexpr double near_in_tolerances = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Whether the segment comes within `reach` pixels.
bool is_near(const Pixel& place, const PixelSegment& segment, double reach) {
  const auto along_x = static_cast<double>(segment.to.x - segment.from.x);
  const auto along_y = static_cast<double>(segment.to.y - segment.from.y);
  const auto x = static_cast<double>(place.x - segment.from.x);
  const auto y = static_cast<double>(place.y - segment.from.y);
  const double squared = along_x * along_x + along_y * along_y;
  constexpr double room = 1.001;  // for round-off: most segments are far beside the place, which costs no root to tell
  const double across = x * along_y - y * along_x;
  if (across * across > room * reach * reach * squared) return false;
  const double share = squared > 0 ? std::clamp((x * along_x + y * along_y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(x - share * along_x, y - share * along_y) <= reach;
}

// The first piece of a straight is what was drawn, others prolong it.
bool is_prolongation(const std::vector<Piece>& pieces, std::size_t i) {
  return i > 0 && pieces[i].straight == pieces[i - 1].straight;
}

// Where prolongations stay whatever is near them.
class KeptGround {
 public:
  KeptGround(const PixelGrid& grid, const RockPlan& plan) : grid_(grid), boundary_(bounding_box(plan.boundary)) {
    for (const PlanOpening& opening : plan.openings) {
      if (opening.left_out) openings_.push_back(bounding_box(opening.outline));
    }
  }

  // `end` and all within `margin`, m.
  [[nodiscard]] bool holds(const Pixel& end, double margin) const {
    const Vec2 place = grid_.centre_of(end);
    const Box around = expanded(Box{place, place}, margin);
    if (!overlap(around, expanded(boundary_, -2 * margin))) return true;
    return std::ranges::any_of(openings_, [&](const Box& opening) { return overlap(around, opening); });
  }

 private:
  const PixelGrid& grid_;
  Box boundary_;
  std::vector<Box> openings_;
};

double length_of(const PixelSegment& line) {
  return std::hypot(static_cast<double>(line.to.x - line.from.x), static_cast<double>(line.to.y - line.from.y));
}

// Prolongations that are of no use where nothing is near the ends that they leave from.
struct Candidates {
  std::vector<std::size_t> pieces;
  std::vector<Pixel> ends;
};

Candidates candidates_of(const std::vector<Piece>& pieces, const KeptGround& kept, double margin, double reach) {
  Candidates candidates;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Pixel& end = pieces[i].segment.from;
    if (!is_prolongation(pieces, i)) {
      drawn = i;
    } else if (length_of(pieces[drawn].segment) > reach && !kept.holds(end, margin)) {
      candidates.pieces.push_back(i);
      candidates.ends.push_back(end);
    }
  }
  return candidates;
}

}  // namespace

std::vector<bool> lonely_prolongations(const std::vector<Piece>& pieces, const PixelGrid& grid, double tolerance,
                                       const RockPlan& plan) {
  const double margin = near_in_tolerances * tolerance;
  const double reach = margin / grid.step();
  std::vector<Piece> drawn;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!is_prolongation(pieces, i)) drawn.push_back(pieces[i]);
  const Candidates candidates = candidates_of(pieces, KeptGround(grid, plan), margin, reach);
  std::vector<char> has_company(candidates.ends.size(), 0);
  visit_meetings(drawn, candidates.ends, reach,
                 [&](std::size_t, std::span<const NearPiece> crowd, std::span<const NearNode> near) {
                   for (const NearNode& end : near) {
                     const int own = pieces[candidates.pieces[at(end.node)]].straight;
                     const bool found = std::ranges::any_of(crowd, [&](const NearPiece& each) {
                       return drawn[at(each.piece)].straight != own && is_near(end.pixel, each.segment, reach);
                     });
                     has_company[at(end.node)] = found ? 1 : 0;
                   }
                 });
  std::vector<bool> lonely(pieces.size(), false);
  for (std::size_t k = 0; k < candidates.pieces.size(); ++k) lonely[candidates.pieces[k]] = has_company[k] == 0;
  return lonely;
}

}  // namespace dda
