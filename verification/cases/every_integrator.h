// All dynamic integrators, those with a parameter at several values of it, under names that tell them apart.
#pragma once

#include <vector>

#include "engine/model/settings.h"

namespace verify {

[[nodiscard]] std::vector<dda::Integrator> every_integrator();

}  // namespace verify
