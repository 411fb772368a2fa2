// Which waves a scene carries across its joints, for predicting their errors.
#pragma once

#include <string>
#include <vector>

#include "engine/app/prediction.h"
#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

struct SurveyedWave {
  int material = 0;
  std::string kind;  // "bar", "P" or "S"
  BlockWave wave;    // over the material's largest blocks and softest interfaces
};

// Waves of `frequency` (Hz) in every material that has interfaces: the bar wave where the blocks form a straight row,
// otherwise P and S waves square across the interfaces. None for a static stage.
std::vector<SurveyedWave> survey_waves(const Model& model, const ContactSet& contacts, const Stage& stage,
                                       double frequency);

}  // namespace dda
