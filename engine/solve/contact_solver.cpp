#include "engine/solve/contact_solver.h"

#include <array>
#include <span>
#include <utility>

#include "engine/contact/contact_set.h"
#include "engine/contact/open_close.h"

namespace dda {

void ContactSolver::begin(BlockMatrix pattern, SolverKind kind, double chi) {
  const Eigen::Index unknowns = pattern.unknowns();
  at_.matrix.begin(std::move(pattern), kind, chi);
  at_.increment.setZero(unknowns);
}

void ContactSolver::set_pattern(BlockMatrix pattern) { at_.matrix.set_pattern(std::move(pattern)); }

const StepSolution& ContactSolver::solve(const StepProblem& problem) {
  at_.contacts.start(problem.contacts);
  at_.bolts.start(problem.bolts);
  at_.pose(problem);
  if (at_.matrix.is_amended()) at_.matrix.outdate();
  convex_.start(problem.guess);
  rises_ = 0;
  is_sure_ = false;
  if (problem.contacts.rule.capacity_is_given) {
    begin_at(problem.guess);
    return settle_from_here();
  }
  at_.increment.setZero();
  if (problem.held.move && friction_.has_something_to_settle(at_)) move_held_blocks();
  return settle_from_here();
}

// Where capacities are given there is one answer, and the way to it is the shorter the nearer it begins.
void ContactSolver::begin_at(const Eigen::VectorXd& increment) {
  at_.increment = increment;
  if (!at_.problem->held.empty()) at_.problem->held.put(at_.increment);
  convex_.go_on_from(at_);
  at_.bolts.aim(at_.increment);
  at_.bolts.follow(1);
}

const StepSolution& ContactSolver::go_on(const StepProblem& problem) {
  at_.contacts.look_at(problem.contacts);
  at_.bolts.look_at(problem.bolts);
  at_.pose(problem);
  return settle_from_here();
}

const StepSolution& ContactSolver::settle_from_here() {
  if (at_.problem->base_version != base_version_) at_.matrix.outdate();
  base_version_ = at_.problem->base_version;
  solution_.broken_contacts.clear();
  solution_.broken_links.clear();
  solution_.failure = Failure::none;
  solution_.settled_from_inside = false;
  solution_.status = settle();
  if (solution_.status == Status::ok) {
    at_.bolts.break_links(solution_.broken_links);
    at_.contacts.break_ends_beyond_strength(solution_.broken_contacts);
  } else {
    at_.matrix.outdate();
    if (solution_.failure == Failure::unsettled) note_restless();
  }
  return solution_;
}

void ContactSolver::admit(const StepProblem& problem, std::size_t k, const std::array<bool, 2>& broken) {
  at_.contacts.look_at(problem.contacts);
  at_.contacts.admit(k, broken, at_.increment);
}

// Held blocks go all their way at once; the others start from rest, or from where they are carried along to. (The
// increments of the step before would be no nearer to the answer where contacts change, and of several answers that
// friction may have favour those that move.)
void ContactSolver::move_held_blocks() {
  if (at_.problem->begins_at_guess) at_.increment = at_.problem->guess;
  at_.problem->held.put(at_.increment);
  InterfaceTrials& contacts = at_.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec4 moved = gap_increment(contacts.element(k), at_.increment);
    if (contacts.is_whole(k) || moved.isZero(0)) continue;
    contacts[k].gap += moved;
    respond_with_friction(contacts.element(k), contacts.strength(k), contacts[k]);
  }
  at_.bolts.aim(at_.increment);
  at_.bolts.follow(1);
}

Status ContactSolver::settle() {
  while (true) {
    const Status status = settle_contacts();
    if (status != Status::ok || !at_.problem->dilates) return status;
    const double change = at_.contacts.follow_dilations();
    if (change <= negligible_force(at_)) return Status::ok;
    if (++rises_ <= at_.problem->max_passes) continue;
    solution_.failure = Failure::unsettled;
    return Status::not_converged;
  }
}

// Not where everything is linear: one cut step is then all there is to do.
bool ContactSolver::settle_quickly(const Patience& most) {
  return friction_.has_something_to_settle(at_) && friction_.find_balance(at_, most);
}

// The nearer to the answer the quick passes begin the surer they find it, and the longer it takes to come so near.
// Those with friction in them hardly ever find it from 1e-5 of the largest force away (7 of 139 in a slope of 481
// blocks), and mostly from 1e-7 (135 of 149). Those with given friction take 2 passes from 1e-5 where they do (171 of
// 197 in nine rocks of 21 to 773 blocks), and 27 in vain where they do not (146 of 158 in a slope of 545): so they get
// a few there, and what is next is 5 passes nearer.
bool ContactSolver::settle_from_inside() {
  if (!interior_.serve(at_) || !interior_.begin(at_)) return false;
  constexpr std::array shares_off{1e-5, 1e-7, 1e-9};
  constexpr Patience at_first{FrictionPasses::short_patience.in_vain, 6};
  const bool is_given = at_.problem->contacts.rule.capacity_is_given;
  bool is_near = false;
  for (const double share_off : std::span(shares_off).subspan(is_given ? 0 : 1)) {
    if (!interior_.approach(at_, share_off)) break;
    is_near = true;
    if (settle_quickly(share_off == shares_off[0] ? at_first : FrictionPasses::short_patience)) return true;
  }
  if (is_given && !is_near) begin_at(at_.problem->guess);
  return false;
}

// Newton's method with whole steps is quickest, and goes in circles at times. Steps cut where the potential is least
// lead out of these; the more of them there were the more follow, so that in the end there are only such, which is
// sure.
Status ContactSolver::settle_with_given_capacities() {
  if (settle_quickly() || settle_from_inside()) return Status::ok;
  constexpr int most_cut_steps = 128;
  for (int cut_steps = 1; cut_steps <= most_cut_steps; cut_steps *= 2) {
    convex_.go_on_from(at_);
    const Status status = convex_.settle(at_, cut_steps);
    solution_.failure = convex_.failure();
    if (solution_.failure != Failure::unsettled) return status;
    if (settle_quickly()) return Status::ok;
  }
  return Status::not_converged;
}

Status ContactSolver::settle_contacts() {
  if (at_.problem->contacts.rule.capacity_is_given) return settle_with_given_capacities();
  if (!is_sure_ && friction_.has_something_to_settle(at_)) {
    if (settle_with_friction()) return Status::ok;
    if (!at_.problem->to_the_end) {
      solution_.failure = Failure::unsettled;
      return Status::not_converged;
    }
    convex_.restart(at_);
    is_sure_ = at_.problem->dilates;
  }
  const Status status = convex_.settle(at_, at_.problem->max_passes);
  solution_.failure = convex_.failure();
  return status;
}

// Where quick passes did not settle they hardly do so in the next step, and are left out of some.
bool ContactSolver::settle_with_friction() {
  constexpr int most_without_quick_passes = 4;
  if (without_quick_passes_ == 0) {
    if (friction_.find_balance(at_, FrictionPasses::patience)) return true;
    note_restless();
  }
  solution_.settled_from_inside = at_.problem->goes_from_inside && settle_from_inside();
  without_quick_passes_ = solution_.settled_from_inside ? (without_quick_passes_ + 1) % most_without_quick_passes : 0;
  return solution_.settled_from_inside;
}

void ContactSolver::note_restless() {
  solution_.restless_contact = -1;
  solution_.restless_force = 0;
  for (std::size_t k = 0; k < at_.contacts.size(); ++k) {
    const InterfaceElement& element = at_.contacts.element(k);
    InterfaceTrial again = at_.contacts[k];
    const double change = update_capacity(element, at_.contacts.strength(k), again) +
                          element.stiffness.cwiseProduct(again.direction).cwiseAbs().maxCoeff();
    if (solution_.restless_contact >= 0 && change <= solution_.restless_force) continue;
    solution_.restless_contact = static_cast<int>(at_.contacts.place(k));
    solution_.restless_force = change;
  }
}

}  // namespace dda
