// The fastest wave that the loads of a model make, where a stage follows it.
#pragma once

#include <optional>

#include "engine/model/step_choice.h"

namespace dda {

// Nothing in static stages, and where a period has less than two steps: what steps pass over is told by
// unseen_loads.h.
inline std::optional<FastestWave> followed_wave(const Model& model, const Stage& stage) {
  if (stage.integrator.is_static) return std::nullopt;
  std::optional<FastestWave> wave = fastest_wave(model, stage, stage.dt);
  return wave && wave->frequency * stage.dt <= 0.5 ? wave : std::nullopt;
}

}  // namespace dda
