// The open-close iteration of Simulation: solve, judge every interface, solve again until no status changes.
#include <cstddef>

#include "dda/contact/open_close.h"
#include "dda/simulation/simulation.h"

namespace dda {
namespace {

// Friction follows the normal force by fixed-point iteration; its last change may be this share of the normal force.
// Far below what a stress or displacement is read to, far above the round-off of a solve.
constexpr double friction_tolerance = 1e-9;

}  // namespace

Status Simulation::find_contact_statuses() {
  trial_ = contacts_.states;
  for (int pass = 0; pass < stage().max_open_close_iterations; ++pass) {
    const Status status = solve_pass();
    if (status != Status::ok) return status;
    if (plan_.contacts) ++counters_.open_close_iterations;
    if (!judge_contacts()) return Status::ok;
  }
  message_ = "the open-close iteration did not settle";
  return Status::not_converged;
}

Status Simulation::solve_pass() {
  if (!matrix_is_current_) {
    const Status status = refactor();
    if (status != Status::ok) return status;
  }
  rhs_ = constant_rhs_;
  if (plan_.contacts_can_change) add_contact_rhs();
  return solve_for_increment();
}

Status Simulation::solve_for_increment() {
  ++counters_.solves;
  const Status status = solver_->solve(rhs_, increment_);
  if (status != Status::ok) {
    message_ = "the linear solver failed";
    return status;
  }
  // 0 times anything not finite is NaN, and so is a sum with a NaN: allFinite(), vectorized.
  if ((0 * increment_).sum() == 0) return Status::ok;
  message_ = "a displacement is not finite";
  return Status::not_finite;
}

// Interfaces whose end-of-step force is not the carried one plus stiffness: open, sliding, or closing again.
void Simulation::add_contact_rhs() {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceState& start = contacts_.states[i];
    const Vec4 difference = force_without_motion(contacts_.elements[i], start, trial_[i]) - start.force;
    if (difference.isZero(0)) continue;
    add_interface_force(contacts_.elements[i], -coefficients_.stiffness * difference, Vec4::Zero(), rhs_);
  }
}

Vec3 Simulation::trial_stress(int block) const {
  const auto i = static_cast<std::size_t>(block);
  return state_.stress[i] + terms_.elasticity[i] * increment_.segment<3>(6 * block + 3);
}

bool Simulation::judge_contacts() {
  bool changed = false;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    const auto old_status = trial_[i].status;
    Vec3 stress_a = Vec3::Zero();
    Vec3 stress_b = Vec3::Zero();
    if (has_stress_rows(element)) {
      stress_a = trial_stress(element.block_a);
      stress_b = trial_stress(element.block_b);
    }
    const bool again = judge(element, contacts_.strengths[i], contacts_.states[i], gap_increment(element, increment_),
                             stress_a, stress_b, friction_tolerance, trial_[i]);
    changed = changed || again;
    if (has_stress_rows(element)) changed = weaken_consistent(i) || changed;
    if (trial_[i].status == old_status) continue;
    matrix_is_current_ = false;
    ++counters_.contact_state_changes;
  }
  return changed;
}

// A consistent interface beyond its strength goes on under the classical law, with the same forces at the start of the
// step, and is judged end by end from the next pass on.
bool Simulation::weaken_consistent(std::size_t i) {
  if (!beyond_strength(contacts_.strengths[i], trial_[i])) return false;
  InterfaceElement& element = contacts_.elements[i];
  const double energy_before = interface_energy(element, contacts_.states[i]);
  element = make_element(model_, contacts_.interfaces[i], InterfaceLaw::classical);
  const Interface& interface = contacts_.interfaces[i];
  set_geometry(model_,
               plan_.finite_kinematics ? current_frame(model_, state_, interface) : reference_frame(model_, interface),
               element);
  contacts_.states[i] = as_classical(contacts_.states[i], element.stiffness);
  trial_[i] = contacts_.states[i];
  audit_.interface_replaced(energy_before - interface_energy(element, contacts_.states[i]));
  sum_internal_forces(internal_old_);
  form_constant_rhs();
  matrix_is_current_ = false;
  ++counters_.contact_state_changes;
  return true;
}

void Simulation::accept_contacts() {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceState& before = contacts_.states[i];
    const InterfaceState& after = trial_[i];
    if (before.status != after.status || before.slip != after.slip)
      audit_.interface_changed(contacts_.elements[i], before, after, gap_increment(contacts_.elements[i], increment_));
  }
  contacts_.states.swap(trial_);
}

}  // namespace dda
