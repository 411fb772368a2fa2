#include "engine/simulation/rayleigh_damping.h"

namespace dda {
namespace {

// Of the foot of a support, as the balance of the step has it.
Vec2 mean_velocity(const BlockSystem& system, std::size_t support) {
  const StepCoefficients& step = system.coefficients;
  const PointSupport& foot = system.model.supports[support];
  return step.load_new * prescribed_velocity(foot, system.end_of_step(step.dt)) +
         step.load_old * prescribed_velocity(foot, system.state.time);
}

}  // namespace

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

void RayleighDamping::add_drive(const BlockSystem& system, double time, Eigen::VectorXd& force) const {
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 velocity = prescribed_velocity(system.model.supports[i], time);
    force.segment<6>(6 * support.block) += stiffness_ * support.rows.transpose() * (support.stiffness * velocity);
  }
}

void RayleighDamping::add_drive_in_step(const BlockSystem& system, Eigen::VectorXd& rhs) {
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 force = stiffness_ * (support.stiffness * mean_velocity(system, i));
    known_.segment<6>(6 * support.block) -= support.rows.transpose() * force;
    rhs.segment<6>(6 * support.block) += support.rows.transpose() * force;
  }
}

double RayleighDamping::work_on_feet(const BlockSystem& system) const {
  const StepCoefficients& step = system.coefficients;
  double work = 0;
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const PointSupport& foot = system.model.supports[i];
    const Vec6 velocity =
        carried_.segment<6>(6 * support.block) + step.damping * system.increment.segment<6>(6 * support.block);
    const Vec2 force = stiffness_ * (support.stiffness * (support.rows * velocity - mean_velocity(system, i)));
    work += force.dot(prescribed_displacement(foot, system.end_of_step(step.dt)) - support.prescribed);
  }
  return work;
}

}  // namespace dda
