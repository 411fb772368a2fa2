#include "engine/model/current_outline.h"

namespace dda {

Polygon current_outline(const Model& model, const State& state, int block) {
  Polygon outline = model.blocks[static_cast<std::size_t>(block)].shape;
  const auto move = [&](Ring& ring) {
    for (Vec2& corner : ring) corner = current_position(model, state, block, corner);
  };
  move(outline.outer);
  for (Ring& hole : outline.holes) move(hole);
  return outline;
}

std::vector<Polygon> current_outlines(const Model& model, const State& state) {
  std::vector<Polygon> outlines;
  for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block)
    outlines.push_back(current_outline(model, state, block));
  return outlines;
}

}  // namespace dda
