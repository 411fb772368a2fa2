// Whether explicit steps would be cheaper than the implicit ones of a stage.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/model/model.h"
#include "engine/simulation/stage_cost.h"

namespace dda {

// What explicit steps in place of implicit ones would take.
struct ExplicitOffer {
  double dt = 0;       // s, the longest that is stable, rounded down
  double seconds = 0;  // CPU time of the steps, as rough as StageCost's
};

// Returns the offer for a stage that costs `cost` as it is. Nothing where it is explicit or static already, where
// explicit steps are not for it, and where they would save less than a fifth.
std::optional<ExplicitOffer> explicit_offer(const Model& model, std::size_t stage, const SceneSize& size,
                                            const StageCost& cost);

}  // namespace dda
