// What drives a scene - a load, or supports or a block that move - as a wave that sets out from it.
#pragma once

#include <optional>
#include <string>

#include "engine/advice/wave_errors.h"
#include "engine/model/model.h"

namespace dda {

struct SceneLoad {
  LoadHistory history;
  const TimeFunction* source = nullptr;  // of the model that the load was found in
  Vec2 place = Vec2::Zero();             // m, of the load
  std::string description;               // for people
  int block = 0;                         // that is driven
  Vec2 motion = Vec2::Zero();            // direction of the force or of the prescribed motion
  Vec2 face = Vec2::Zero();              // normal into the rock of the loaded edge; zero where something else drives
  Vec2 looked_at = Vec2::Zero();         // m, the measurement farthest from it; where there is none, its own place
};

// Unit vector of the way from there: square to a loaded edge, else towards where it is looked at; zero where that is
// its own place.
Vec2 way_of(const SceneLoad& load);

// The first edge or point load whose history is not constant, up to the end of the run; where there is none, the first
// support or held block that moves.
std::optional<SceneLoad> scene_load(const Model& model);

// s, up to which a history is zero.
double start_of(const TimeFunction& function);

// "a table of 40 points"; "constant".
std::string words_for(const TimeFunction& history);

// The highest frequency of a sine among loads and prescribed motions, Hz.
std::optional<double> highest_sine_frequency(const Model& model);

}  // namespace dda
