// What the rock is in each stage: elasticity and density of its materials, and strength and springs of its joints can
// change when a stage begins (loosened, improved or soaked rock, concrete that hardens, joints that weather or get
// wet). Blocks can come in.
//
// Materials and joints keep their names, places and laws, and penalties go by the materials of the start; what may
// change of them is said in check_rock_changes.cpp. A stage that changes nothing has empty tables.
#pragma once

#include <vector>

#include "engine/model/material.h"

namespace dda {

struct RockOfStage {
  std::vector<Material> materials;    // all of the model's, from the start of the stage on; empty: as before
  std::vector<JointMaterial> joints;  // the same
  std::vector<int> added = {};        // blocks that come in at the start of the stage, as drawn and free of stress
};

}  // namespace dda
