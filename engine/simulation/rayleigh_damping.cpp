#include "engine/simulation/rayleigh_damping.h"

namespace dda {

void RayleighDamping::begin(const Stage& stage) {
  mass_ = stage.integrator.is_static ? 0 : stage.material_damping.mass;
  stiffness_ = stage.integrator.is_static ? 0 : stage.material_damping.stiffness;
}

StepCoefficients RayleighDamping::in_matrix(StepCoefficients step) const {
  step.mass += step.damping * mass_;
  step.stiffness += step.damping * stiffness_;
  return step;
}

void RayleighDamping::force_of(const LinearOperators& operators, const Eigen::VectorXd& x,
                               const Eigen::VectorXd& mass_times_x, Eigen::VectorXd& force) const {
  force.resize(x.size());
  operators.stiffness_times.multiply(x, force);
  force = mass_ * mass_times_x + stiffness_ * force;
}

void RayleighDamping::take_off_known(const LinearOperators& operators, const StepCoefficients& step,
                                     const MotionAtStart& start, Eigen::VectorXd& rhs) {
  carried_ = step.damping_v * start.velocity + step.damping_a * start.acceleration;
  mass_times_carried_ = step.damping_v * start.momentum + step.damping_a * start.inertia_force;
  force_of(operators, carried_, mass_times_carried_, known_);
  rhs -= known_;
}

const Eigen::VectorXd& RayleighDamping::force_in_step(const LinearOperators& operators, const StepCoefficients& step,
                                                      const Eigen::VectorXd& d) {
  product_.resize(d.size());
  operators.inertia_times.multiply(d, product_);
  force_of(operators, d, product_, force_);
  force_ = known_ + step.damping * force_;
  return force_;
}

}  // namespace dda
