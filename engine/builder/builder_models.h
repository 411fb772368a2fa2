// For tests of this folder: models that have a material and no blocks yet.
#pragma once

#include "engine/model/model.h"

namespace dda {

inline Model with_rock() {
  Model model;
  model.materials = {{"rock", 1000, 1e9, 0.2, PlaneState::stress}};
  return model;
}

}  // namespace dda
