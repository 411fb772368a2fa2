#include "engine/solve/interface_trials.h"

#include <algorithm>
#include <atomic>

#include "engine/contact/contact_set.h"
#include "engine/contact/contact_sharing.h"
#include "engine/contact/open_close.h"
#include "engine/core/parallel.h"
#include "engine/solve/step_matrix.h"

namespace dda {
namespace {

const ContactRows no_rows{Vec4::Constant(-1), 0};  // differs from all that can be active

// Whether break_ends may find something to do at the end of the step.
bool can_break(const EndStrength& strength, const InterfaceTrial& trial) {
  const bool has_nothing_left = trial.broken[0] && trial.broken[1] && strength.is_dry() && strength.friction_drop <= 0;
  return !trial.rule.sticks && !has_nothing_left;
}

}  // namespace

InterfaceTrial InterfaceTrials::started(std::size_t k) const {
  return start_trial(element(k), strength(k), state(k), contacts_.rule);
}

void InterfaceTrials::start(const ChangingContacts& contacts) {
  contacts_ = contacts;
  trials_.resize(contacts.places.size());
  std::atomic<bool> some_can_break = false;
  parallel_for_each(trials_.size(), contacts_worth_sharing, [&](std::size_t k) {
    trials_[k] = started(k);
    if (can_break(strength(k), trials_[k])) some_can_break.store(true, std::memory_order_relaxed);
  });
  some_can_break_ = some_can_break;
  if (matrix_rows_.size() != trials_.size()) matrix_rows_.assign(trials_.size(), no_rows);
}

void InterfaceTrials::restart() {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    trials_[k].gap = trials_[k].start;
    forget_rise(element(k), strength(k), trials_[k]);
    if (!is_whole(k)) update_capacity(element(k), strength(k), trials_[k]);
  }
}

void InterfaceTrials::admit(std::size_t k, const std::array<bool, 2>& broken, const Eigen::VectorXd& d) {
  InterfaceTrial trial = started(k);
  trial.gap += gap_increment(element(k), d);
  for (std::size_t end = 0; end < 2; ++end) trial.broken[end] = trial.broken[end] || broken[end];
  respond(element(k), trial);
  some_can_break_ = true;
  const auto at = static_cast<std::ptrdiff_t>(k);
  trials_.insert(trials_.begin() + at, trial);
  matrix_rows_.insert(matrix_rows_.begin() + at, no_rows);
}

std::int64_t InterfaceTrials::take_up_rows() {
  std::atomic<std::int64_t> changes = 0;
  parallel_for_each(trials_.size(), contacts_worth_sharing, [&](std::size_t k) {
    if (take_up_rows(k)) changes.fetch_add(1, std::memory_order_relaxed);
  });
  return changes;
}

bool InterfaceTrials::take_up_rows(std::size_t k) {
  const ContactRows rows{trials_[k].active, trials_[k].coupling};
  if (matrix_rows_[k] == rows) return false;
  matrix_rows_[k] = rows;
  return true;
}

void InterfaceTrials::add_stiffness(double factor, BlockMatrix& matrix) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) add_contact(factor, element(k), matrix_rows_[k], true, true, matrix);
}

void InterfaceTrials::add_rhs(double factor, Eigen::VectorXd& rhs) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const Vec4 constant = constant_force(k, element(k));
    if (!constant.isZero(0)) add_interface_force(element(k), -factor * constant, Vec4::Zero(), rhs);
  }
}

Vec4 InterfaceTrials::constant_force(std::size_t k, const InterfaceSprings& springs) const {
  const InterfaceTrial& trial = trials_[k];
  const Vec4 reached = trial.gap - trial.start;  // dilation has moved the force, not the gap
  return trial.force - force_in_matrix(k, springs, reached) - state(k).force;
}

void InterfaceTrials::aim(const Eigen::VectorXd& newton_step) {
  for (std::size_t k = 0; k < trials_.size(); ++k) trials_[k].direction = gap_increment(element(k), newton_step);
}

double InterfaceTrials::mismatch() const {
  double mismatch = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    if (is_whole(k)) continue;
    InterfaceTrial after = trials_[k];
    after.gap += after.direction;
    respond(element(k), after);
    const Vec4 expected = force_change(element(k), trials_[k].active, trials_[k].coupling, trials_[k].direction);
    mismatch = std::max(mismatch, (after.force - trials_[k].force - expected).cwiseAbs().maxCoeff());
  }
  return mismatch;
}

double InterfaceTrials::largest_force() const {
  double largest = 0;
  for (const InterfaceTrial& trial : trials_) largest = std::max(largest, trial.force.cwiseAbs().maxCoeff());
  return largest;
}

void InterfaceTrials::take_out(double factor, LineSlope& line) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const InterfaceTrial& trial = trials_[k];
    const Vec4 along = force_change(element(k), trial.active, trial.coupling, trial.direction);
    line.curvature -= factor * along.dot(trial.direction);
    line.at_start -= factor * (along.dot(trial.gap - state(k).gap) + trial.direction.dot(state(k).force));
  }
}

void InterfaceTrials::add_slope(double factor, double t, double& slope) const {
  for (std::size_t k = 0; k < trials_.size(); ++k) slope += factor * force_along(element(k), trials_[k], t);
}

void InterfaceTrials::follow(double share) {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    trials_[k].gap += share * trials_[k].direction;
    respond(element(k), trials_[k]);
  }
}

void InterfaceTrials::measure(std::size_t k, const Eigen::VectorXd& d) {
  trials_[k].gap = state(k).gap + gap_increment(element(k), d);
  respond(element(k), trials_[k]);
}

double InterfaceTrials::follow_capacities() {
  double change = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k)
    if (!is_whole(k)) change = std::max(change, update_capacity(element(k), strength(k), trials_[k]));
  return change;
}

double InterfaceTrials::follow_dilations() {
  double change = 0;
  for (std::size_t k = 0; k < trials_.size(); ++k)
    change = std::max(change, update_dilation(element(k), strength(k), trials_[k]));
  return change;
}

void InterfaceTrials::break_ends_beyond_strength(std::vector<int>& broken) {
  if (!some_can_break_) return;
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    if (!break_ends(element(k), strength(k), trials_[k])) continue;
    update_capacity(element(k), strength(k), trials_[k]);
    broken.push_back(contacts_.places[k]);
  }
}

}  // namespace dda
