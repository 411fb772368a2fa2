// The damping of material that acts in a stage: none in static ones.
#pragma once

#include "engine/model/settings.h"

namespace dda {

[[nodiscard]] inline MaterialDamping acting_damping(const Stage& stage) {
  return stage.integrator.is_static ? MaterialDamping() : stage.material_damping;
}

}  // namespace dda
