// Rayleigh damping of a linear scene: forces -C v with C = a M + b K, over all inertia and stiffness there is, that of
// joints and supports among it. Every vibration of angular frequency w then has the damping ratio a/(2 w) + b w/2, and
// a wave of that frequency loses the share 1 - exp(-2 pi ratio) of its amplitude over each wavelength.
//
// The dampers b k of supports stand on the feet of their springs: where these move, they resist the motion of the block
// against them alone.
#pragma once

#include <Eigen/Core>

#include "engine/model/settings.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {

// What a step starts from, 6 numbers a block.
struct MotionAtStart {
  Eigen::Map<const Eigen::VectorXd> velocity, acceleration;
  const Eigen::VectorXd &momentum, &inertia_force;  // M v, M a
};

class RayleighDamping {
 public:
  // From the start of a stage on; it acts in dynamic stages.
  void begin(const Stage& stage);
  [[nodiscard]] bool acts() const { return mass_ != 0 || stiffness_ != 0; }

  // The step's coefficients with what C adds to those of M and K in its matrix.
  [[nodiscard]] StepCoefficients in_matrix(StepCoefficients step) const;

  // C x from M x; x and both others have 6 numbers a block.
  void force_of(const LinearOperators& operators, const Eigen::VectorXd& x, const Eigen::VectorXd& mass_times_x,
                Eigen::VectorXd& force) const;

  // Takes C (damping_v v0 + damping_a a0), the part of the balance that is known, off the right-hand side.
  void take_off_known(const LinearOperators& operators, const StepCoefficients& step, const MotionAtStart& start,
                      Eigen::VectorXd& rhs);

  // Adds what feet of supports that move drive the blocks with by their dampers: at the velocities of a moment (s), and
  // in the balance of the step, for which it has to follow take_off_known().
  void add_drive(const BlockSystem& system, double time, Eigen::VectorXd& force) const;
  void add_drive_in_step(const BlockSystem& system, Eigen::VectorXd& rhs);

  // Books what dampers take of the motion of a step, and what held blocks and feet of supports bring in of it: by the
  // mean of their forces at its two ends, as the work of all other forces is. After take_off_known(), before the state
  // moves.
  void book(const LinearOperators& operators, const MotionAtStart& start, BlockSystem& system);

  // What feet of supports would bring in (W per m of thickness) were the springs' dampers passed by these velocities, 6
  // numbers a block, and the feet moved as they do at `time` (s).
  [[nodiscard]] double power_of_feet(const BlockSystem& system, double time, const Eigen::VectorXd& velocity) const;

 private:
  // Works (J per m of thickness) over the increment of a step, of forces at one moment or in the balance of the step.
  struct Works {
    double on_blocks = 0, on_held_blocks = 0, on_feet = 0;
  };
  [[nodiscard]] Works works_in_balance(const BlockSystem& system);
  [[nodiscard]] Works works_of_start(const LinearOperators& operators, const MotionAtStart& start,
                                     const BlockSystem& system);
  [[nodiscard]] double work_on_feet(const BlockSystem& system, const Eigen::Ref<const Eigen::VectorXd>& velocity,
                                    double load_old, double load_new) const;

  double mass_ = 0;       // 1/s
  double stiffness_ = 0;  // s

  // Within a step.
  Eigen::VectorXd carried_, mass_times_carried_;    // damping_v v0 + damping_a a0, and M times that
  Eigen::VectorXd known_;                           // N, C times that
  Eigen::VectorXd product_, of_increment_, force_;  // N: C d, and what the balance had
};

}  // namespace dda
