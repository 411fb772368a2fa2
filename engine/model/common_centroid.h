// The centroid of several blocks taken together.
#pragma once

#include <vector>

#include "engine/model/model.h"

namespace dda {

// As drawn, m; the blocks' moments must be filled, and there must be one at least.
Vec2 common_centroid(const std::vector<int>& blocks, const Model& model);

}  // namespace dda
