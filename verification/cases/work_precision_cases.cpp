#include "verification/cases/work_precision_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "verification/precision/grid.h"
#include "verification/precision/plane_run.h"
#include "verification/precision/robust.h"
#include "verification/precision/run_job.h"
#include "verification/precision/summary.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using Wanted = std::function<bool(const PrecisionScheme&)>;

// Runs of the study that cost at most so many passes.
std::vector<Measured> runs_below(Problem problem, double passes, const Wanted& wanted, Outcome& outcome) {
  std::vector<Measured> runs;
  for (const PrecisionJob& job : study_jobs()) {
    if (job.problem != problem || !wanted(job.scheme) || planned_passes(job) > passes) continue;
    Measured measured;
    measured.job = job;
    measured.result = run_job(job);
    measured.runs = 1;
    outcome.counters.steps += static_cast<std::int64_t>(measured.result.steps);
    outcome.counters.solves += static_cast<std::int64_t>(measured.result.solves);
    runs.push_back(measured);
  }
  return runs;
}

double least_error(const std::vector<Measured>& runs, Norm norm) {
  double least = std::numeric_limits<double>::infinity();
  for (const Measured& measured : runs) least = std::fmin(least, error_of(measured, norm));
  return least;
}

std::string words(Norm norm) { return norm == Norm::l2 ? "L2 norm" : "velocity and amplitude"; }

constexpr double enough_passes = 1.2e4;  // for the accurate scheme at every error asked for
constexpr double passes_to_see = 3e4;    // of finer runs too
constexpr double plate_passes = 2e5;     // 3 % and the runs around it

bool is_accurate(const PrecisionScheme& scheme) { return scheme == accurate_scheme(Problem::bar); }
bool is_thesis(const PrecisionScheme& scheme) { return scheme == thesis_scheme(); }
// True for implicit steps: a pass of explicit ones is a product alone, so the two do not compare.
bool is_engine(const PrecisionScheme& scheme) { return scheme.is_engine() && scheme != explicit_scheme(); }

// What the thesis' scheme makes of `times` the passes that the accurate one needs for `error`: still more than that.
void assert_gain(double times, double error, Norm norm, const std::vector<Measured>& accurate, Outcome& outcome) {
  const auto cheapest = cheapest_run(accurate, Cost::passes, norm, error);
  if (!cheapest)
    throw std::runtime_error(fmt::format("the accurate scheme does not reach {} in the {}", error, words(norm)));
  const double passes = cheapest->result.passes();
  const double left = least_error(runs_below(Problem::bar, times * passes, is_thesis, outcome), norm);
  outcome.assertions.push_back(
      expect(fmt::format(
                 "least error of the thesis' scheme in {:g} times the passes in which the accurate one has {:g} %, {} "
                 "(error: wanted over measured)",
                 times, 100 * error, words(norm)),
             "-")
          .is(left)
          .against(error, "wave equation; block sizes 0.5 to 12.5 m, time steps from 0.5 us")
          .off_by(error / left)
          .within(1, "promised: the accurate scheme is cheaper by more than that"));
}

Outcome gain_case() {
  Outcome outcome;
  const std::vector<Measured> accurate = runs_below(Problem::bar, enough_passes, is_accurate, outcome);
  for (const Norm norm : {Norm::l2, Norm::reading}) {
    assert_gain(10, 0.01, norm, accurate, outcome);
    assert_gain(40, 0.003, norm, accurate, outcome);
  }
  return outcome;
}

// Passes of the accurate scheme's cheapest run within `error` over those of the cheapest of `all`.
void assert_on_front(const std::string& which, double error, const std::vector<Measured>& all, Outcome& outcome) {
  const auto best = cheapest_run(all, Cost::passes, Norm::l2, error);
  const Problem problem = all.front().job.problem;
  const auto ours = cheapest_run(runs_of(all, problem, accurate_scheme(problem)), Cost::passes, Norm::l2, error);
  const double times = best && ours ? ours->result.passes() / best->result.passes() : std::nan("");
  outcome.assertions.push_back(
      expect(fmt::format("passes of the accurate scheme over those of the cheapest{}, {:g} % in the L2 norm", which,
                         100 * error),
             "-")
          .is(times)
          .against(1, fmt::format("cheapest of all: {}", best ? best->job.key() : "none"))
          .absolutely()
          .within(0.01, "promised: it is on the front"));
}

// The accurate scheme among all laws and integrators: of all runs, and of those that no cancellation of errors helps.
Outcome front_case() {
  Outcome outcome;
  const std::vector<Measured> all = runs_below(Problem::bar, passes_to_see, is_engine, outcome);
  for (const double error : {0.1, 0.03, 0.01, 0.003}) {
    assert_on_front("", error, all, outcome);
    assert_on_front(" whose finer runs hold too", error, robust_runs(all, Norm::l2, error), outcome);
  }
  return outcome;
}

Outcome plate_case() {
  Outcome outcome;
  const std::vector<Measured> all = runs_below(Problem::plane, plate_passes, is_engine, outcome);
  for (const double error : {0.1, 0.05, 0.03}) assert_on_front(" in a plate", error, all, outcome);
  return outcome;
}

// Explicit steps just below their limit have the error of implicit ones of a length that adds next to nothing, and with
// half of their length they have it still: blocks alone are left.
Outcome explicit_plate_case() {
  Outcome outcome;
  const double p_speed = plane_pulse().p_speed;
  for (const int along : {20, 28}) {
    const double size = plane_half_side / along;
    const auto error_with = [&](const PrecisionScheme& scheme, double number) {
      const PrecisionResult result = run_job({Problem::plane, scheme, size, number * size / p_speed});
      outcome.counters.steps += static_cast<std::int64_t>(result.steps);
      outcome.counters.solves += static_cast<std::int64_t>(result.solves);
      return result.error;
    };
    const double implicit_error = error_with(accurate_scheme(Problem::plane), 0.35);
    const double half = error_with(explicit_scheme(), 0.14), whole = error_with(explicit_scheme(), 0.28);
    outcome.assertions.push_back(
        expect(fmt::format("L2 error in a plate of {0} x {0} blocks, explicit steps of c_p dt/L = 0.28 "
                           "(error: beyond that of implicit steps of 0.35)",
                           2 * along),
               "-")
            .is(whole)
            .against(implicit_error, "accurate default, same blocks")
            .off_by(std::max(0.0, whole / implicit_error - 1))
            .within(0.01, "promised: no less accurate"));
    outcome.assertions.push_back(
        expect(fmt::format("the same over that of steps half as long, {0} x {0} blocks", 2 * along), "-")
            .is(whole / half)
            .against(1, "theory: errors of time steps are of fourth order")
            .absolutely()
            .within(0.01, "measured 0.001"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> work_precision_cases() {
  return {
      {"work-precision-gain", "What accuracy costs the thesis' scheme on the bar", {32}, CaseLabel::slow, gain_case},
      {"work-precision-front", "The accurate scheme among all laws and integrators", {32}, CaseLabel::slow, front_case},
      {"work-precision-plate",
       "The same in a plate, P and S waves from a smooth source",
       {42},
       CaseLabel::slow,
       plate_case},
      {"explicit-steps-plate",
       "Explicit steps in a plate, P and S waves from a smooth source",
       {42},
       CaseLabel::slow,
       explicit_plate_case}};
}

}  // namespace verify
