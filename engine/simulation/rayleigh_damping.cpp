#include "engine/simulation/rayleigh_damping.h"

#include "engine/simulation/acting_damping.h"

namespace dda {
namespace {

// Velocity of the foot of a support: those at both ends of the step with these weights.
Vec2 foot_velocity(const BlockSystem& system, std::size_t support, double load_old, double load_new) {
  const PointSupport& foot = system.model.supports[support];
  Vec2 velocity = Vec2::Zero();
  if (load_new != 0) velocity += load_new * prescribed_velocity(foot, system.end_of_step(system.coefficients.dt));
  if (load_old != 0) velocity += load_old * prescribed_velocity(foot, system.state.time);
  return velocity;
}

}  // namespace

void RayleighDamping::begin(const Stage& stage) {
  mass_ = acting_damping(stage).mass;
  stiffness_ = acting_damping(stage).stiffness;
}

StepCoefficients RayleighDamping::in_matrix(StepCoefficients step) const {
  step.mass += step.damping * mass_;
  step.stiffness += step.damping * stiffness_;
  return step;
}

void RayleighDamping::force_of(const LinearOperators& operators, const Eigen::VectorXd& x,
                               const Eigen::VectorXd& mass_times_x, Eigen::VectorXd& force) const {
  force.resize(x.size());
  operators.stiffness.multiply(x, force);
  force = mass_ * mass_times_x + stiffness_ * force;
}

void RayleighDamping::take_off_known(const LinearOperators& operators, const StepCoefficients& step,
                                     const MotionAtStart& start, Eigen::VectorXd& rhs) {
  carried_ = step.damping_v * start.velocity + step.damping_a * start.acceleration;
  mass_times_carried_ = step.damping_v * start.momentum + step.damping_a * start.inertia_force;
  force_of(operators, carried_, mass_times_carried_, known_);
  rhs -= known_;
}

void RayleighDamping::add_drive(const BlockSystem& system, double time, Eigen::VectorXd& force) const {
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 velocity = prescribed_velocity(system.model.supports[i], time);
    force.segment<6>(6 * support.block) += stiffness_ * support.rows.transpose() * (support.stiffness * velocity);
  }
}

void RayleighDamping::add_drive_in_step(const BlockSystem& system, Eigen::VectorXd& rhs) {
  const StepCoefficients& c = system.coefficients;
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 force = stiffness_ * (support.stiffness * foot_velocity(system, i, c.load_old, c.load_new));
    known_.segment<6>(6 * support.block) -= support.rows.transpose() * force;
    rhs.segment<6>(6 * support.block) += support.rows.transpose() * force;
  }
}

double RayleighDamping::work_on_feet(const BlockSystem& system, const Eigen::Ref<const Eigen::VectorXd>& velocity,
                                     double load_old, double load_new) const {
  if (!system.plan.moving_supports) return 0;
  double work = 0;
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 against_foot =
        support.rows * velocity.segment<6>(6 * support.block) - foot_velocity(system, i, load_old, load_new);
    const Vec2 motion = prescribed_displacement(system.model.supports[i], system.end_of_step(system.coefficients.dt)) -
                        support.prescribed;
    work += stiffness_ * (support.stiffness * against_foot).dot(motion);
  }
  return work;
}

double RayleighDamping::power_of_feet(const BlockSystem& system, double time, const Eigen::VectorXd& velocity) const {
  double power = 0;
  for (std::size_t i = 0; i < system.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 force = stiffness_ * (support.stiffness * (support.rows * velocity.segment<6>(6 * support.block)));
    power += force.dot(prescribed_velocity(system.model.supports[i], time));
  }
  return power;
}

// Works of the damping force C (damping d + damping_v v0 + damping_a a0) less what drives it.
RayleighDamping::Works RayleighDamping::works_in_balance(const BlockSystem& system) {
  const StepCoefficients& step = system.coefficients;
  product_ = carried_ + step.damping * system.increment;
  return {system.increment.dot(force_), system.held.work(force_),
          work_on_feet(system, product_, step.load_old, step.load_new)};
}

// Works of C v0 less what drives it. C is symmetric: d . C v0 = v0 . C d.
RayleighDamping::Works RayleighDamping::works_of_start(const LinearOperators& operators, const MotionAtStart& start,
                                                       const BlockSystem& system) {
  Works works;
  product_.setZero();
  if (system.plan.moving_supports) add_drive(system, system.state.time, product_);
  works.on_blocks = start.velocity.dot(of_increment_) - system.increment.dot(product_);
  works.on_feet = work_on_feet(system, start.velocity, 1, 0);
  if (!system.held.move) return works;
  works.on_held_blocks = -system.held.work(product_);
  force_of(operators, start.velocity, start.momentum, product_);
  works.on_held_blocks += system.held.work(product_);
  return works;
}

void RayleighDamping::book(const LinearOperators& operators, const MotionAtStart& start, BlockSystem& system) {
  const StepCoefficients& step = system.coefficients;
  product_.resize(system.increment.size());
  operators.inertia.multiply(system.increment, product_);
  force_of(operators, system.increment, product_, of_increment_);
  force_ = known_ + step.damping * of_increment_;
  // The momentum of held blocks is what the integrator has, and not what their prescribed velocities make of it.
  const double of_momentum = mass_ * (system.increment.dot(start.momentum) - start.velocity.dot(product_));
  Works mean = works_in_balance(system);
  double by_integrator = 0;
  if (const double off_centre = 0.5 - step.load_old; off_centre != 0) {
    Works old = works_of_start(operators, start, system);
    old.on_blocks += of_momentum;
    const auto centre = [&](double& work, double at_start) {
      const double off = off_centre * (work - at_start) / step.load_new;  // of the change from start to end
      work -= off;
      return off;
    };
    by_integrator = centre(mean.on_blocks, old.on_blocks) - centre(mean.on_held_blocks, old.on_held_blocks);
    centre(mean.on_feet, old.on_feet);
  }
  system.audit.damping_worked(mean.on_blocks - mean.on_feet, by_integrator);
  system.audit.moved_against(mean.on_held_blocks - mean.on_feet);
}

}  // namespace dda
