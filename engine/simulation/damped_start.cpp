#include "engine/simulation/damped_start.h"

#include <memory>
#include <utility>

#include "engine/linear/solver_choice.h"

namespace dda {
namespace {

class Jump {
 public:
  Jump(const BlockSystem& system, const LinearOperators& operators, const RayleighDamping& damping, double dt)
      : system_(system), operators_(operators), damping_(damping), dt_(dt), matrix_(operators.stiffness.pattern()) {
    StepCoefficients sum;  // M + dt C
    sum.mass = 1;
    sum.damping = dt;
    assemble(damping.in_matrix(sum), operators, {}, matrix_);
    HeldCouplings().take_out(system.held, matrix_);
    solver_ = make_solver(choose_solver({matrix_.size(), matrix_.couplings()}));
    solver_->analyze(matrix_);
    can_solve_ = solver_->factorize(matrix_) == Status::ok;
  }

  ChangeAtOnce made_by(const Eigen::VectorXd& unbalanced) {
    Eigen::VectorXd change, before;
    if (!solve(dt_ * unbalanced, change)) return {};
    for (int time = 0; time < 2; ++time) {
      before = change;
      if (!solve(impulse_of(before), change)) return {};
    }
    // M w = dt C (before - w): the dampers' forces are those of velocities before - w against what moves them.
    before -= change;
    return {std::move(change), brought_by_motion_against(before)};
  }

 private:
  bool solve(Eigen::VectorXd rhs, Eigen::VectorXd& answer) {
    system_.held.clear(rhs);
    answer.setZero(rhs.size());
    return can_solve_ && solver_->solve(rhs, answer) == Status::ok;
  }

  // dt C x
  [[nodiscard]] Eigen::VectorXd impulse_of(const Eigen::VectorXd& x) const {
    Eigen::VectorXd inertia(x.size()), force;
    operators_.inertia.multiply(x, inertia);
    damping_.force_of(operators_, x, inertia, force);
    return dt_ * force;
  }

  [[nodiscard]] double brought_by_motion_against(const Eigen::VectorXd& velocity) const {
    double work = dt_ * damping_.power_of_feet(system_, system_.state.time, velocity);
    if (!system_.held.move) return work;
    const Eigen::VectorXd impulse = impulse_of(velocity);
    for (const int block : system_.held.blocks)
      work -= impulse.segment<6>(6 * block).dot(system_.state.velocity[static_cast<std::size_t>(block)]);
    return work;
  }

  const BlockSystem& system_;
  const LinearOperators& operators_;
  const RayleighDamping& damping_;
  double dt_;
  BlockMatrix matrix_;
  std::unique_ptr<LinearSolver> solver_;
  bool can_solve_ = false;
};

}  // namespace

ChangeAtOnce change_at_once(const BlockSystem& system, const LinearOperators& operators, const RayleighDamping& damping,
                            double dt, const Eigen::VectorXd& unbalanced) {
  return Jump(system, operators, damping, dt).made_by(unbalanced);
}

}  // namespace dda
