// The open-close iteration of Simulation.
//
// With friction capacities given, the step minimizes the convex, piecewise quadratic
//   1/2 d A0 d - d . rhs + stiffness factor * (potentials of all interfaces)
// over the increments d, A0 being the matrix without dry contacts. Newton's method solves with the rows active at the
// point reached; a line search along its step (exact: the slope is continuous and increasing) makes every pass lower
// the minimum sought, so no set of statuses comes twice and the passes end. Two outer loops follow: capacities move to
// friction times normal force until forces stand still, and ends beyond their strength break, at most once each.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/contact/open_close.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// Forces stand still when they change by no more than this share of the largest contact force: far below what a stress
// or displacement is read to.
constexpr double force_tolerance = 1e-10;

// Passes after each of which capacities follow the normal forces.
constexpr int eager_passes = 10;

// A slope this much smaller than that at the start of the Newton step counts as zero.
constexpr double slope_tolerance = 1e-9;

// Zero of an increasing function on [0, 1] with slope(0) < 0 < slope(1).
template <typename Slope>
double zero_of(const Slope& slope, double at_zero, double at_one) {
  double low = 0;
  double high = 1;
  double low_value = at_zero;
  double high_value = at_one;
  const double small = slope_tolerance * std::abs(at_zero);
  for (int i = 0; i < 60; ++i) {
    // Regula falsi, kept off the ends so that the bracket shrinks from both sides.
    const double share = std::clamp(low_value / (low_value - high_value), 0.05, 0.95);
    const double middle = low + share * (high - low);
    const double value = slope(middle);
    if (std::abs(value) <= small) return middle;
    (value < 0 ? low : high) = middle;
    (value < 0 ? low_value : high_value) = value;
  }
  return low;
}

}  // namespace

Status Simulation::find_contact_statuses() {
  start_trials();
  if (newton_.matrix_amended) matrix_is_current_ = false;
  target_.swap(increment_);  // the last step's increments, as a first guess for an iterative solver
  increment_.setZero();
  if (held_.move() && has_something_to_settle()) move_held_blocks();
  int rises = 0;
  while (true) {
    const Status status = settle_contacts();
    if (status != Status::ok) return status;
    if (plan_.dilation && !dilations_stand_still()) {
      if (++rises <= stage().max_open_close_iterations) continue;
      message_ = unsettled_message();
      return Status::not_converged;
    }
    if (!break_interfaces()) return Status::ok;
  }
}

bool Simulation::dilations_stand_still() {
  double change = 0;
  for (std::size_t i = 0; i < trial_.size(); ++i)
    change = std::max(change, update_dilation(contacts_.elements[i], contacts_.strengths[i], trial_[i]));
  return change <= negligible_force();
}

// Back to the start of the step, but for what broke or rose since.
void Simulation::restart_trials() {
  increment_.setZero();
  target_.setZero();
  matrix_is_current_ = false;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    trial_[i].gap = trial_[i].start;
    if (!is_whole(contacts_.elements[i], trial_[i]))
      update_capacity(contacts_.elements[i], contacts_.strengths[i], trial_[i]);
  }
  bolts_.start_trials();
}

void Simulation::start_trials() {
  trial_.resize(contacts_.elements.size());
  for (std::size_t i = 0; i < trial_.size(); ++i)
    trial_[i] = start_trial(contacts_.elements[i], contacts_.strengths[i], contacts_.states[i], contact_rule_);
  bolts_.start_trials();
}

// Newton's method with line search. Capacities follow the normal forces after every pass at first, which is quickest
// where it works, and then only when the statuses have settled for the capacities at hand, which is sure.
Status Simulation::settle_contacts() {
  if (has_something_to_settle()) {
    if (newton_finds_balance()) return Status::ok;
    restart_trials();
  }
  for (int pass = 0; pass < stage().max_open_close_iterations; ++pass) {
    if (plan_.contacts) ++counters_.open_close_iterations;
    const Status status = solve_pass();
    if (status != Status::ok) return status;
    const bool settled = take_newton_step();
    if (!plan_.contacts_can_change) return Status::ok;
    if (!settled && pass >= eager_passes) continue;
    if (capacities_stand_still() && settled) return Status::ok;
  }
  message_ = unsettled_message();
  return Status::not_converged;
}

std::string Simulation::unsettled_message() const {
  std::size_t worst = 0;
  double largest = -1;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (has_stress_rows(contacts_.elements[i])) continue;
    InterfaceTrial again = trial_[i];
    const double change = update_capacity(contacts_.elements[i], contacts_.strengths[i], again) +
                          contacts_.elements[i].stiffness.cwiseProduct(again.direction).cwiseAbs().maxCoeff();
    if (change > largest) largest = change, worst = i;
  }
  if (largest < 0) return "the open-close iteration did not settle";
  const auto name = [&](int block) { return model_.blocks[static_cast<std::size_t>(block)].name; };
  return fmt::format(
      "the open-close iteration did not settle in {} passes; blocks \"{}\" and \"{}\" still change most, by {:.2g} N: "
      "take another dt or a static stage first",
      stage().max_open_close_iterations, name(contacts_.elements[worst].block_a),
      name(contacts_.elements[worst].block_b), largest);
}

// Coulomb friction as a fixed point of given capacities.
bool Simulation::capacities_stand_still() {
  double change = 0;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (is_whole(contacts_.elements[i], trial_[i])) continue;
    change = std::max(change, update_capacity(contacts_.elements[i], contacts_.strengths[i], trial_[i]));
  }
  return change <= negligible_force();
}

Status Simulation::solve_pass() {
  bool changed = false;
  const Status status = bring_matrix_up_to_date(true, changed);
  if (status != Status::ok) return status;
  rhs_ = constant_rhs_;
  if (plan_.contacts_can_change) add_contact_rhs(rhs_);
  return solve_for_increment(target_);
}

// Forces at the end of the step are force + K_active (gap at the end - gap reached); what of that does not depend on
// the unknowns goes to the right, beside the forces carried over in constant_rhs_.
void Simulation::add_contact_rhs(Eigen::VectorXd& rhs) const {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    if (has_stress_rows(element)) continue;
    const Vec4 constant = constant_force(i, element);
    if (!constant.isZero(0)) add_interface_force(element, -coefficients_.stiffness * constant, Vec4::Zero(), rhs);
  }
  bolts_.add_rhs(coefficients_.stiffness, rhs);
}

Vec4 Simulation::constant_force(std::size_t i, const InterfaceSprings& springs) const {
  const InterfaceTrial& trial = trial_[i];
  const Vec4 reached = trial.gap - trial.start;  // dilation has moved the force, not the gap
  return trial.force - matrix_rows_[i].cwiseProduct(springs.stiffness).cwiseProduct(reached) -
         contacts_.states[i].force;
}

// Moves along the Newton step as far as the potential falls. True when it was taken whole and the forces became what it
// took them to be.
bool Simulation::take_newton_step() {
  if (!plan_.contacts_can_change) {
    increment_.swap(target_);
    follow_trials(1);
    return true;
  }
  target_ -= increment_;  // from here on the direction
  for (std::size_t i = 0; i < trial_.size(); ++i) trial_[i].direction = gap_increment(contacts_.elements[i], target_);
  bolts_.aim(target_);
  const bool settled = mismatch_of_whole_step() <= negligible_force();
  const bool whole = settled || held_.moved_by(target_);  // held blocks are where they are to be from then on
  const double share = whole ? 1 : length_of_step();
  increment_ += share * target_;
  follow_trials(share);
  target_ = increment_;
  return settled;
}

// Largest difference between a force after the whole Newton step and what the rows active now make of it. (Rows alone
// cannot tell whether statuses have settled: where blocks just touch they come and go with round-off.)
double Simulation::mismatch_of_whole_step() const {
  double mismatch = bolts_.mismatch_of_whole_step();
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    if (is_whole(element, trial_[i])) continue;
    InterfaceTrial after = trial_[i];
    after.gap += after.direction;
    respond(element, after);
    const Vec4 expected = trial_[i].active.cwiseProduct(element.stiffness).cwiseProduct(trial_[i].direction);
    mismatch = std::max(mismatch, (after.force - trial_[i].force - expected).cwiseAbs().maxCoeff());
  }
  return mismatch;
}

double Simulation::negligible_force() const {
  double largest = bolts_.largest_force();
  for (const InterfaceTrial& trial : trial_) largest = std::max(largest, trial.force.cwiseAbs().maxCoeff());
  return std::max(force_tolerance * largest, round_off_of_forces());
}

// What a solve leaves of the forces on blocks that only just touch.
double Simulation::round_off_of_forces() const {
  constexpr double share = 1e-13;  // of the largest entry of the right-hand side
  return share * constant_rhs_.cwiseAbs().maxCoeff();
}

double Simulation::length_of_step() {
  matrix_.multiply(target_, rhs_);  // A p; the dry contacts' part is taken out again below
  double curvature = target_.dot(rhs_);
  double slope_at_start = increment_.dot(rhs_) + held_.coupled_work(increment_, target_) - target_.dot(constant_rhs_);
  const double factor = coefficients_.stiffness;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    if (has_stress_rows(element)) continue;
    const InterfaceTrial& trial = trial_[i];
    const Vec4 along = element.stiffness.cwiseProduct(trial.active).cwiseProduct(trial.direction);
    curvature -= factor * along.dot(trial.direction);
    slope_at_start -=
        factor * (along.dot(trial.gap - contacts_.states[i].gap) + trial.direction.dot(contacts_.states[i].force));
  }
  curvature -= factor * bolts_.active_curvature();
  slope_at_start -= factor * bolts_.active_slope();
  const auto slope = [&](double t) {
    double value = slope_at_start + t * curvature + factor * bolts_.force_along(t);
    for (std::size_t i = 0; i < trial_.size(); ++i)
      if (!has_stress_rows(contacts_.elements[i])) value += factor * force_along(contacts_.elements[i], trial_[i], t);
    return value;
  };
  const double at_zero = slope(0);
  const double at_one = slope(1);
  return at_one <= slope_tolerance * std::abs(at_zero) || at_zero >= 0 ? 1 : zero_of(slope, at_zero, at_one);
}

// Gaps and forces after `share` of the Newton step.
void Simulation::follow_trials(double share) {
  bolts_.follow_trials(share);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (has_stress_rows(contacts_.elements[i]) || !plan_.contacts_can_change) {
      follow_whole(i);
      continue;
    }
    trial_[i].gap += share * trial_[i].direction;
    respond(contacts_.elements[i], trial_[i]);
  }
}

// Of an interface that is linear in its gaps.
void Simulation::follow_whole(std::size_t i) {
  const InterfaceElement& element = contacts_.elements[i];
  InterfaceTrial& trial = trial_[i];
  trial.gap = contacts_.states[i].gap + gap_increment(element, increment_);
  if (has_stress_rows(element)) {
    trial.force = elastic_force(element, trial.gap, trial_stress(element.block_a), trial_stress(element.block_b));
  } else {
    respond(element, trial);
  }
}

Vec3 Simulation::trial_stress(int block) const {
  const auto i = static_cast<std::size_t>(block);
  return state_.stress[i] + terms_.elasticity[i] * increment_.segment<3>(6 * block + 3);
}

bool Simulation::break_interfaces() {
  if (!plan_.contacts_can_change) return false;
  bool broke = bolts_.break_links();
  bool weakened = false;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (has_stress_rows(contacts_.elements[i])) {
      weakened = weaken_consistent(i) || weakened;
    } else if (break_ends(contacts_.strengths[i], trial_[i])) {
      update_capacity(contacts_.elements[i], contacts_.strengths[i], trial_[i]);
      broke = true;
    }
  }
  if (weakened) {
    sum_internal_forces(internal_old_);
    form_constant_rhs();
  }
  return broke || weakened;
}

// An interface with an end beyond its strength goes on under the classical law, with the same forces at the start of
// the step and that end broken: blocks lose with the law the forces that it makes of their strains, and what that
// leaves may be within the strength again. Its other end is judged from the next pass on.
bool Simulation::weaken_consistent(std::size_t i) {
  if (contact_rule_.sticks) return false;
  const std::array<bool, 2> broken = ends_beyond_strength(contacts_.strengths[i], trial_[i].force);
  if (!broken[0] && !broken[1]) return false;
  InterfaceElement& element = contacts_.elements[i];
  const double energy_before = interface_energy(element, contacts_.states[i]);
  element = make_element(model_, contacts_.interfaces[i], InterfaceLaw::classical);
  const Interface& interface = contacts_.interfaces[i];
  set_geometry(model_,
               plan_.finite_kinematics ? current_frame(model_, state_, interface) : reference_frame(model_, interface),
               element);
  contacts_.states[i] = as_classical(contacts_.states[i], element.stiffness);
  trial_[i] = start_trial(element, contacts_.strengths[i], contacts_.states[i], contact_rule_);
  trial_[i].gap += gap_increment(element, increment_);
  trial_[i].broken = broken;
  respond(element, trial_[i]);
  matrix_rows_[i].setConstant(-1);
  matrix_is_current_ = false;
  audit_.interface_replaced(energy_before - interface_energy(element, contacts_.states[i]));
  return true;
}

void Simulation::accept_contacts() {
  const double weight = coefficients_.stiffness;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceState before = contacts_.states[i];
    const InterfaceState after = finish_trial(contacts_.elements[i], before, trial_[i]);
    if (trial_[i].force != after.force && !held_.empty())  // the rest of their work is in audit_held_blocks
      audit_.held_blocks_moved_against(weight *
                                       held_.gap_increment(contacts_.elements[i]).dot(trial_[i].force - after.force));
    if (before.status != after.status || before.slip != after.slip || trial_[i].force != after.force)
      audit_.interface_changed(contacts_.elements[i], before, after, gap_increment(contacts_.elements[i], increment_),
                               weight * (trial_[i].force - after.force),
                               weight * dashpot_force(contacts_.elements[i], trial_[i]));
    contacts_.states[i] = after;
  }
}

}  // namespace dda
