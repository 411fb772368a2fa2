// Chapter 6, rockbursts.
#pragma once

#include "verification/chapters/scene_runs.h"
#include "verification/chapters/statement.h"

namespace verify {

[[nodiscard]] Chapter chapter_6(const SceneFolder& folder, bool quick);

}  // namespace verify
