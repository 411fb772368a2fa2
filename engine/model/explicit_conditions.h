// What a scene and a stage must be so that explicit steps (central differences, ADR 49) can follow them: the one list
// that refuses a scene which asks for them, and that the adviser goes by before it offers them.
#pragma once

#include <optional>
#include <string>

#include "engine/model/model.h"

namespace dda {

struct ExplicitObstacle {
  std::string where;     // completes "central differences ..."
  std::string expected;  // instead
};

// The first one, if any. Says nothing of the time step, whose limit is another matter (stability_limit.h).
[[nodiscard]] std::optional<ExplicitObstacle> explicit_obstacle(const Model& model, const Stage& stage);

}  // namespace dda
