// Cells that fill rock of a scene, and rings around its openings.
#pragma once

#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

// "fill" of `rock`; the plan has its openings. `seed` is that of the rock.
void read_fills(const Field& rock, int seed, const Model& model, RockPlan& plan);

// "rings" of an opening as lines; none where it has none.
std::vector<PlanLine> read_rings(const Field& opening, const Ring& outline, const Model& model);

}  // namespace dda
