// Where the outline of a block is now.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// An outline, with its holes, whose vertices are where `place_of` has them.
template <typename PlaceOf>
[[nodiscard]] Polygon outline_with(Polygon outline, const PlaceOf& place_of) {
  const auto move = [&](Ring& ring) {
    for (Vec2& corner : ring) corner = place_of(corner);
  };
  move(outline.outer);
  for (Ring& hole : outline.holes) move(hole);
  return outline;
}

// Returns the outline of a block, with its holes, where it is in `state`, m.
[[nodiscard]] Polygon current_outline(const Model& model, const State& state, int block);

// Returns the outlines of all blocks, in their order.
[[nodiscard]] std::vector<Polygon> current_outlines(const Model& model, const State& state);

}  // namespace dda
