// Where the outline of a block is now.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// With its holes, m.
[[nodiscard]] Polygon current_outline(const Model& model, const State& state, int block);

// Of every block.
[[nodiscard]] std::vector<Polygon> current_outlines(const Model& model, const State& state);

}  // namespace dda
