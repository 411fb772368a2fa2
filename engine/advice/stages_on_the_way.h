// Whether the stages that a wave passes in have one kind of steps, and one rock.
#pragma once

#include <cstddef>
#include <string>

#include "engine/advice/load_history.h"
#include "engine/model/model.h"

namespace dda {

// The wave is foretold with the steps of one stage, in the rock that the run begins with: it has to pass before steps
// of another kind, or other rock, come. A clause for people, empty where it does.
std::string why_steps_change(const Model& model, std::size_t stage, const SceneLoad& load, double window);

}  // namespace dda
