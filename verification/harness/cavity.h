// Loads of scenes with a cavity in rock: a pressure on its wall, and an outside that absorbs waves.
#pragma once

#include "engine/model/model.h"
#include "engine/model/time_function.h"

namespace verify {

// `pressure` (Pa) times history on the wall of the cavity around the origin.
void press_wall(dda::Model& model, double pressure, const dda::TimeFunction& history);

// Dashpots of the first material's P and S waves on the whole outside.
void absorb_outside(dda::Model& model);

}  // namespace verify
