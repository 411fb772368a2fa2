#include "engine/app/run_verdict.h"

namespace dda {

// The first that is wrong, or all that is to be said.
RunVerdict judge_run(const Simulation& simulation) {
  RunVerdict energy = judge_energy(simulation);
  if (energy.status != Status::ok) return energy;
  RunVerdict penetration = judge_penetration(simulation);
  if (penetration.status != Status::ok) return penetration;
  RunVerdict motion = judge_motion(simulation);
  if (motion.status != Status::ok || energy.message.empty()) return motion;
  return {Status::ok, motion.message.empty() ? energy.message : energy.message + "; " + motion.message};
}

}  // namespace dda
