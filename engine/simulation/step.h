// One time step of a block system, of either kind, and what both kinds do alike.
#pragma once

#include <Eigen/Core>
#include <string>

#include "engine/core/status.h"
#include "engine/linear/block_matrix.h"
#include "engine/simulation/block_system.h"
#include "engine/solve/step_matrix.h"

namespace dda {

// What a step is taken for.
enum class Taken {
  to_the_end,       // whatever it takes
  unless_cut,       // where it does not settle quickly shorter ones are rather taken
  if_hardly_slips,  // the same where more than a few contacts slide or a joint breaks: see hardly_slips.h
};

class Step {
 public:
  Step() = default;
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
  virtual ~Step() = default;

  // Makes solver and matrices ready for the stage that system.clock and system.plan tell. `pattern`: of the matrix.
  virtual void set_up(BlockMatrix pattern) = 0;
  // The first moment of that stage, or of longer steps within it: what follows from the state there.
  virtual void begin() = 0;
  // Advances the system by dt; anything but ok leaves it as it was, and message() says why.
  [[nodiscard]] virtual Status advance(double dt, Taken taken) = 0;
  // Its stage is over and another begins: the ledger is left as all kinds of step count it.
  virtual void end() {}
  // Between stages: a step of the other kind goes on, or has gone before.
  virtual void hand_over() = 0;
  virtual void take_over() {}

  // The last step left something for the next: forces may be in balance and yet be no equilibrium.
  [[nodiscard]] virtual bool is_provisional() const { return false; }

  [[nodiscard]] virtual StoredEnergy stored_energy() const = 0;
  [[nodiscard]] virtual const std::string& message() const = 0;
};

// Forces that accelerate the blocks at the start of a stage.
Eigen::VectorXd accelerating_forces(const BlockSystem& system);

// The head of accepting a step: blocks and clock move by system.increment.
void move_blocks(Kinematics kinematics, BlockSystem& system);

// Its tail, when contacts, bolts and supports have followed and forces.internal_new is known: the ledger, damping, held
// blocks, and new forces become old. `inertia_work`: increment . M a_w, see energy_audit.h. Returns the factor by which
// velocities were damped.
double finish_step(double inertia_work, const StoredEnergy& stored, BlockSystem& system);

// Damping of a whole step; in static stages all of the velocity. Returns the factor.
double damp_velocities(BlockSystem& system);

// In words, for people.
std::string sentence(Failure failure);

}  // namespace dda
