#include "engine/simulation/linear_step.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/phase_clock.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/prescribed_motion.h"

namespace dda {
void LinearStep::set_up(BlockMatrix pattern) {
  BlockSystem& s = system_;
  const Stage& stage = s.stage_in_force();
  const Eigen::Index unknowns = pattern.unknowns();
  pattern = BlockMatrix(0, {});  // comes again from the operators, once they need no more room for themselves
  set_step_size(stage.dt);
  linear_.set_up();
  matrix_.begin(linear_.operators->stiffness.pattern(), s.plan.solver, s.plan.chi.largest, MatrixUse::stays);
  for (Eigen::VectorXd* vector : {&next_momentum_, &rhs_}) vector->setZero(unknowns);
}

void LinearStep::set_step_size(double dt) {
  system_.coefficients = step_coefficients(system_.stage_in_force().integrator, dt);
  matrix_.outdate();
}

void LinearStep::hand_over() {
  write_linear_states(system_);
  linear_.end();
  matrix_.end();
}

Status LinearStep::advance(double dt, Taken /*taken*/) {
  BlockSystem& s = system_;
  if (dt != s.coefficients.dt) set_step_size(dt);
  const double end = s.end_of_step(dt);
  if (s.plan.loads) s.loads_at(end, s.forces.load_new);
  form_rhs();
  aim(s.model, s.state, LoadTime::at(end), s.held);
  const Status status = solve();
  if (status == Status::ok) {
    accept();
  } else {
    message_ = sentence(matrix_.failure());
  }
  return status;
}

void LinearStep::form_rhs() {
  const PhaseScope scope(Phase::right_hand_side);
  const StepCoefficients& c = system_.coefficients;
  const BlockForces& forces = system_.forces;
  in_stretches(rhs_.size(), [&](const VectorStretch& here) {
    here.of(rhs_) = c.mass_v * here.of(linear_.momentum) - here.of(forces.internal_old);
    if (c.mass_a != 0) here.of(rhs_) += c.mass_a * here.of(linear_.inertia_force);
    if (system_.plan.loads)
      here.of(rhs_) += c.load_new * here.of(forces.load_new) + c.load_old * here.of(forces.load_old);
    if (system_.plan.gravity) here.of(rhs_) += here.of(system_.external.weight());
  });
  add_dashpot_and_support_rhs(system_, rhs_);
  if (!linear_.rayleigh.acts()) return;
  linear_.rayleigh.take_off_known(*linear_.operators, c, linear_.motion(), rhs_);
  if (system_.plan.moving_supports) linear_.rayleigh.add_drive_in_step(system_, rhs_);
}

Status LinearStep::solve() {
  const BlockSystem& s = system_;
  if (!matrix_.is_current()) {
    matrix_.assemble(s.held, [&](BlockMatrix& values) {
      assemble(linear_.rayleigh.in_matrix(s.coefficients), *linear_.operators, s.damping, values);
    });
    const Status status = matrix_.factorize();
    if (status != Status::ok) return status;
  }
  if (is_iterative(s.plan.solver)) foresee_increment();
  return matrix_.solve(s.held, rhs_, system_.increment);
}

// Where the iteration starts: as if the acceleration stayed as it is.
void LinearStep::foresee_increment() {
  const BlockSystem& s = system_;
  const double dt = s.coefficients.dt;
  in_stretches(system_.increment.size(), [&](const VectorStretch& here) {
    here.of(system_.increment) =
        dt * here.of(flat(s.state.velocity)) + dt * dt / 2 * here.of(flat(s.state.acceleration));
  });
}

void LinearStep::accept() {
  const PhaseScope scope(Phase::acceptance);
  BlockSystem& s = system_;
  if (linear_.rayleigh.acts()) linear_.rayleigh.book(*linear_.operators, linear_.motion(), s);
  move_blocks(Kinematics::small, s);
  if (s.plan.supports) accept_supports(s);
  s.reinforcement.linings.advance(s.increment);
  linear_.sum_internal_forces(s.forces.internal_new);
  const double work = follow_inertia_force();
  const double factor = finish_step(work, linear_.stored_energy(), s);
  if (factor != 1) linear_.momentum *= factor;
  if (s.plan.is_static) linear_.inertia_force.setZero();
}

// M a1 from the change of M v, as a1 follows from that of v. Returns the work against it, see energy_audit.h.
double LinearStep::follow_inertia_force() {
  const StepCoefficients& c = system_.coefficients;
  linear_.operators->inertia.multiply(flat(system_.state.velocity), next_momentum_);
  double work = (1 - c.weight_new_a) * dot(system_.increment, linear_.inertia_force);
  in_stretches(linear_.inertia_force.size(), [&](const VectorStretch& here) {
    here.of(linear_.inertia_force) =
        (here.of(next_momentum_) - here.of(linear_.momentum) - c.v_a0 * here.of(linear_.inertia_force)) / c.v_a1;
  });
  work += c.weight_new_a * dot(system_.increment, linear_.inertia_force);
  linear_.momentum.swap(next_momentum_);
  return work;
}

}  // namespace dda
