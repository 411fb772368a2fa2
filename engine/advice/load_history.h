// The load of a scene as a wave that sets out from it.
#pragma once

#include <optional>
#include <string>

#include "engine/advice/wave_errors.h"
#include "engine/model/model.h"

namespace dda {

struct SceneLoad {
  LoadHistory history;
  Vec2 place = Vec2::Zero();  // m, of the load
  std::string description;    // for people
};

// The first edge or point load whose history is not constant, up to the end of the run.
std::optional<SceneLoad> scene_load(const Model& model);

// The highest frequency of a sine among loads and prescribed motions, Hz.
std::optional<double> highest_sine_frequency(const Model& model);

}  // namespace dda
