// Whether what drives a scene sends one plane wave along its way: figures are of a load that is alone, on all of a side
// that nothing else holds, in steps of one kind. Each of these says in a clause for people what is against it; it is
// empty where nothing is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/advice/load_finding.h"
#include "engine/advice/load_history.h"
#include "engine/model/model.h"

namespace dda {

struct DrivenWave {
  Vec2 direction = Vec2::UnitX();  // unit, into the rock from where it is driven
  bool row = false;                // in a bar; else in a mesh
  double distance = 0;             // m, to where it is looked at
  WaveTiming timing;
};

// `sudden`: loads of the model that jump.
std::string why_no_plane_wave(const Model& model, std::size_t stage, const SceneLoad& load, const DrivenWave& wave,
                              const std::vector<LoadFinding>& sudden);

}  // namespace dda
