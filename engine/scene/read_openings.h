// Openings of rock in a scene.
#pragma once

#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

PlanOpening read_opening(const Field& field, const Model& model);

}  // namespace dda
