#include "engine/simulation/force_balance.h"

#include <cstddef>

#include "engine/core/phase_clock.h"
#include "engine/simulation/kinematic_update.h"
#include "engine/simulation/prescribed_motion.h"

namespace dda {

void form_rhs(const BlockSystem& system, Eigen::VectorXd& rhs) {
  const PhaseScope scope(Phase::right_hand_side);
  const StepCoefficients& c = system.coefficients;
  const State& state = system.state;
  const BlockForces& forces = system.forces;
  rhs = -forces.internal_old;
  if (forces.kept.jump.size() > 0) rhs += c.load_old * forces.kept.jump;
  if (forces.by_faces.size() > 0) rhs -= c.stiffness * forces.by_faces;
  if (system.plan.loads) rhs += c.load_new * forces.load_new + c.load_old * forces.load_old;
  if (system.plan.gravity) rhs += system.external.weight();
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    rhs.segment<6>(static_cast<Eigen::Index>(6 * i)) +=
        momentum(system.terms.inertia[i], c.mass_v * state.velocity[i] + c.mass_a * state.acceleration[i]);
  if (feels_spin(system.plan)) add_centrifugal_forces(system.terms, rhs);
  add_dashpot_and_support_rhs(system, rhs);
  if (system.plan.reinforcement.linings_yield) system.reinforcement.linings.add_constant_forces(c.stiffness, rhs);
}

}  // namespace dda
