#include "engine/simulation/step.h"

#include <cstddef>

#include "engine/simulation/equilibrium.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/terms/velocity_damping.h"

namespace dda {

Eigen::VectorXd accelerating_forces(const BlockSystem& system) {
  Eigen::VectorXd unbalanced = system.unbalanced_forces();
  for (const auto& [block, matrix] : system.damping)
    unbalanced.segment<6>(6 * block) -= matrix * system.state.velocity[static_cast<std::size_t>(block)];
  return unbalanced;
}

void move_blocks(Kinematics kinematics, BlockSystem& system) {
  const StepCoefficients& c = system.coefficients;
  system.audit.dashpots_worked(c, system.damping, system.state, system.increment);
  advance_blocks(c, system.terms, system.increment, system.state);
  deform_blocks(kinematics, system.increment, system.terms, system.state);
  system.state.time = system.end_of_step(c.dt);
}

double finish_step(double inertia_work, const StoredEnergy& stored, BlockSystem& system) {
  BlockForces& forces = system.forces;
  system.audit.record(system.coefficients, inertia_work, stored,
                      {forces.load_old, forces.load_new, system.external.weight(), forces.internal_old,
                       forces.internal_new, forces.kept.jump},
                      system.increment);
  audit_held_blocks(system);
  forces.kept.forget();
  const double factor = damp_velocities(system);
  if (!system.plan.is_static) set_held_rates(system.model, system.state);
  forces.internal_old.swap(forces.internal_new);
  forces.load_old.swap(forces.load_new);
  if (system.plan.is_static) note_exchanged_forces(system);
  ++system.costs.counters.steps;
  return factor;
}

double damp_velocities(BlockSystem& system) {
  const StepPlan& plan = system.plan;
  if (!plan.velocity_damping && !plan.is_static) return 1;
  const Stage& stage = system.stage();
  const double factor =
      plan.is_static ? 0 : velocity_factor(stage.velocity_factor, stage.damping_rate, system.coefficients.dt);
  for (Vec6& velocity : system.state.velocity) velocity *= factor;
  if (plan.is_static)
    for (Vec6& acceleration : system.state.acceleration) acceleration.setZero();
  system.audit.velocities_damped(factor);
  return factor;
}

std::string sentence(Failure failure) {
  switch (failure) {
    case Failure::none: return "";
    case Failure::unsettled: return "the open-close iteration did not settle";
    case Failure::singular_matrix:
      return "the system matrix is not positive definite: blocks differ too much in size or stiffness, data "
             "overflow, or, in a static stage, a block is not held; dda check remarks on the first and the last";
    case Failure::linear_solver: return "the linear solver failed";
    case Failure::not_finite: return "a displacement is not finite";
  }
  return "";
}

}  // namespace dda
