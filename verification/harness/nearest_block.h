#pragma once

#include "engine/model/model.h"

namespace verify {

// The block whose centroid is nearest to `place` (m); the first of several.
[[nodiscard]] int nearest_block(const dda::Model& model, const dda::Vec2& place);

}  // namespace verify
