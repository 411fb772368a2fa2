// What is cleaned where lines become blocks: nothing is, without a line in a list.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/types.h"

namespace dda {

enum class Cleaning {
  line_without_length,  // a line, or a straight part of one, shorter than a step of the grid
  line_not_used,        // no block ends at it: outside, along the boundary, or a dangling end as a whole
  dangle_trimmed,       // a part of a line that ends inside a block
  end_prolonged,        // a line that ended short of another by less than the tolerance
  lines_overlap,        // a line runs along another, whose joint counts
  sliver_merged,        // a block narrower than the tolerance went to a neighbour
  sliver_dropped,       // one without neighbour was left out
  small_block_merged,   // asked for by least_area
  sharp_block_merged,   // asked for by least_angle
  short_edge_closed,    // two corners nearer than the tolerance, or than a fill allows, became one
  round_off_closed,     // two corners, or a corner and a line, apart by no more than round-off became one
  touching_parted,      // the outline of a block touched itself in a point
  gap_closed,           // ends of lines of an outline, apart by less than the tolerance, became one
};
std::string_view to_string(Cleaning cleaning);

// One thing that was cleaned, and where.
struct Cleaned {
  Cleaning what = Cleaning::dangle_trimmed;
  Vec2 from, to;       // ends of a stretch; the same point twice for a block or a corner
  double size = 0;     // m of a stretch or distance, m2 of a block
  std::string origin;  // of the line, as the plan has it
};

}  // namespace dda
