#include "engine/solve/convex_passes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/phase_clock.h"

namespace dda {
namespace {

// Passes after each of which capacities follow the normal forces, which is quickest where it works. After that they do
// so only when the statuses have settled for the capacities at hand, which is sure.
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

double negligible_force(const Iterate& at) {
  return at.negligible_force(std::max(at.bolts.largest_force(), at.contacts.largest_force()));
}

void ConvexPasses::start(const Eigen::VectorXd& guess) {
  target_ = guess;
  image_.resize(guess.size());
}

void ConvexPasses::restart(Iterate& at) {
  at.increment.setZero();
  target_.setZero();
  at.matrix.outdate();
  at.contacts.restart();
  at.bolts.restart();
}

void ConvexPasses::go_on_from(Iterate& at) {
  target_ = at.increment;
  at.matrix.outdate();
  for (std::size_t k = 0; k < at.contacts.size(); ++k) at.contacts.measure(k, at.increment);
}

Status ConvexPasses::settle(Iterate& at, int most_passes) {
  failure_ = Failure::none;
  for (int pass = 0; pass < most_passes; ++pass) {
    if (!at.problem->contacts.elements.empty()) ++at.costs.counters.open_close_iterations;
    const Status status = solve_pass(at);
    if (status != Status::ok) return status;
    const bool settled = take_newton_step(at);
    if (at.is_linear()) return Status::ok;
    if (!settled && pass >= eager_passes) continue;
    const double change = at.contacts.follow_capacities();  // Coulomb friction as a fixed point of given capacities
    if (change <= negligible_force(at) && settled) return Status::ok;
  }
  failure_ = Failure::unsettled;
  return Status::not_converged;
}

Status ConvexPasses::solve_pass(Iterate& at) {
  bool changed = false;
  Status status = at.bring_matrix_up_to_date(changed);
  if (status == Status::ok) {
    rhs_ = at.problem->rhs;
    at.add_constant_forces(rhs_);
    status = at.matrix.solve(at.problem->held, rhs_, target_);
  }
  if (status != Status::ok) failure_ = at.matrix.failure();
  return status;
}

// Moves along the Newton step as far as the potential falls. True when it was taken whole and the forces became what it
// took them to be.
bool ConvexPasses::take_newton_step(Iterate& at) {
  const PhaseScope scope(Phase::judging);
  if (at.is_linear()) {
    at.increment = target_;
    return true;
  }
  step_ = target_ - at.increment;
  at.contacts.aim(step_);
  at.bolts.aim(step_);
  const double mismatch = std::max(at.bolts.mismatch(), at.contacts.mismatch());
  const bool settled = mismatch <= negligible_force(at);
  const bool whole = settled || at.problem->held.moved_by(step_);  // held blocks are where they are to be from then on
  const double share = whole ? 1 : length_of_step(at);
  at.increment += share * step_;
  at.contacts.follow(share);
  at.bolts.follow(share);
  target_ = at.increment;
  return settled;
}

double ConvexPasses::length_of_step(const Iterate& at) {
  const StepProblem& problem = *at.problem;
  at.matrix.values().multiply(step_, image_);  // the contacts' part is taken out again below
  LineSlope line;
  line.curvature = step_.dot(image_);
  line.at_start = at.increment.dot(image_) + at.matrix.couplings().work(at.increment, step_) - step_.dot(problem.rhs);
  at.contacts.take_out(problem.factor, line);
  at.bolts.take_out(problem.factor, line);
  const auto slope = [&](double t) {
    double value = line.at_start + t * line.curvature;
    at.bolts.add_slope(problem.factor, t, value);
    at.contacts.add_slope(problem.factor, t, value);
    return value;
  };
  const double at_zero = slope(0);
  const double at_one = slope(1);
  return at_one <= slope_tolerance * std::abs(at_zero) || at_zero >= 0 ? 1 : zero_of(slope, at_zero, at_one);
}

}  // namespace dda
