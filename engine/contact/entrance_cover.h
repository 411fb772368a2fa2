// The covers of two blocks' entrance block, which are what the narrow phase chooses from.
//
// Hold block b and move block a without turning it. The places that a cannot take, because the two would overlap, are
// the Minkowski difference of b and a: the entrance block (Shi, Contact theory, Science China Technological Sciences
// 58, 2015). Its outline is made of covers. A cover is a vertex of one block on an edge of the other whose normal lies
// between the vertex' own edges, so that a reflex corner has none. In the plane of translations a cover is a straight
// stretch as long as the edge; the vertex' distance from the edge's line is that of the place taken now from the
// stretch's line, and the end of a stretch is where the vertex meets a vertex of the other block. Covers that are not
// on the outline lie within the entrance block: real_overlap.h and cover_corners.h tell.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

struct Cover {
  VertexContact contact;
  double beyond =
      0;           // m, by which the vertex' foot lies past the edge's nearer end; 0 at the end, negative on the edge
  int corner = 0;  // that end: a vertex of the edge's block
  double coming_gap = 0;  // m, after the motion that is foreseen
  double past = 0;        // m, what `beyond` is before feet near the end count as at it
  // m, by which the foot lies past the first and the last end of the edge at the moment at which the motion that is
  // foreseen closes the gap; -infinity where it closes none.
  std::array<double, 2> met_past = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  bool counts = true;  // as a contact
  bool goes = false;   // counts no more once all have been asked
};

// Sine of the angle by which a vertex' own edges may dip below the edge it rests on: contacts of blocks that lie flat
// on each other rock within it. By as much of its gap a vertex may lie past an end.
inline constexpr double entrance_slack = 0.05;

// Unit normal of an edge, out of its block.
Vec2 normal_of(const Outlines& outlines, int edge);

// How far from the place taken now, m.
struct CoverRange {
  double reach;      // the largest gap
  double depth;      // how far behind the edge
  double round_off;  // gaps and places on edges that differ by less are the same
};

// Puts the covers of two blocks in the place of what `found` holds.
void find_covers(const Outlines& outlines, int a, int b, const CoverRange& range, std::vector<Cover>& found);

}  // namespace dda
