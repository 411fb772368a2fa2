#include "engine/model/current_outline.h"

namespace dda {

Polygon current_outline(const Model& model, const State& state, int block) {
  return outline_with(model.blocks[static_cast<std::size_t>(block)].shape,
                      [&](const Vec2& corner) { return current_position(model, state, block, corner); });
}

std::vector<Polygon> current_outlines(const Model& model, const State& state) {
  std::vector<Polygon> outlines;
  for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block)
    outlines.push_back(current_outline(model, state, block));
  return outlines;
}

}  // namespace dda
