#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

// Sides with columns that the engine makes beside them, as a scene asks for them: waves that rise through the base,
// layers, gravity, and what something on the surface scatters.
std::vector<Case> free_field_scene_cases();

}  // namespace verify
