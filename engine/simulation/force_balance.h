// The right-hand side of a step that follows contacts: loads, weight and momentum less what is exerted at its start.
#pragma once

#include <Eigen/Core>

#include "engine/simulation/block_system.h"

namespace dda {

// Blocks that spin are pulled apart.
inline bool feels_spin(const StepPlan& plan) { return plan.finite_kinematics && !plan.is_static; }

void form_rhs(const BlockSystem& system, Eigen::VectorXd& rhs);

}  // namespace dda
