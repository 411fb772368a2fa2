#include "verification/precision/grid.h"

#include <array>
#include <cmath>

#include "verification/precision/bar_run.h"
#include "verification/precision/plane_run.h"
#include "verification/study/grid.h"
#include "verification/thesis/reference.h"

namespace verify {
namespace {

bool is_first_order(const PrecisionScheme& scheme) { return scheme.integrator == "thesis"; }

// What takes more passes is far from every front (0.3 s of CPU time on a bar).
constexpr double most_passes = 5e6;

void add(std::vector<PrecisionJob>& jobs, const PrecisionJob& job) {
  if (planned_passes(job) <= most_passes) jobs.push_back(job);
}

// How many blocks the 50 m up to the receiver have. The springs' compliance and the blocks' dispersion cancel in the
// thesis' scheme near 2.5 m: there the sizes lie close.
constexpr std::array bar_blocks = {4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 32, 40, 64, 100};

// First order needs the short ones; what is of second order has nothing left to gain there.
std::vector<double> bar_steps(const PrecisionScheme& scheme) {
  return is_first_order(scheme) ? geometric(5e-7, 5e-4, std::sqrt(2.0)) : geometric(2e-5, 1.6e-3, std::sqrt(2.0));
}

void add_bar(std::vector<PrecisionJob>& jobs, Problem problem, const PrecisionScheme& scheme) {
  for (const int blocks : bar_blocks)
    for (const double dt : bar_steps(scheme)) add(jobs, {problem, scheme, 50.0 / blocks, dt});
}

void add_bar_yardstick(std::vector<PrecisionJob>& jobs, Problem problem, const PrecisionScheme& scheme) {
  const double c = thesis_reference().bar.wave_speed();
  const bool limit = scheme.integrator == limit_differences;
  for (const int elements : {5, 7, 10, 14, 20, 28, 40, 56, 80, 113, 160, 226, 320, 452, 640})
    for (const double cfl : limit ? std::vector{1.0} : std::vector{0.5, 0.7, 0.9})
      jobs.push_back({problem, scheme, 50.0 / elements, cfl * 50.0 / elements / c});
}

std::vector<double> plane_courant_numbers(const PrecisionScheme& scheme) {
  if (scheme.is_yardstick()) return {0.5, 0.7, 0.9};
  if (is_first_order(scheme)) return {0.016, 0.0625, 0.25, 1};
  if (scheme == explicit_scheme()) return {0.14, 0.28};  // stable up to 0.287
  return {0.35, 0.7, 1, 1.4, 2};
}

void add_plane(std::vector<PrecisionJob>& jobs, const PrecisionScheme& scheme) {
  const double c = plane_pulse().p_speed;
  const std::vector<int> cells =
      scheme.is_yardstick() ? std::vector{20, 28, 40, 56, 80, 113, 160} : std::vector{14, 20, 28, 40, 56};
  for (const int along : cells)
    for (const double number : plane_courant_numbers(scheme)) {
      const double size = plane_half_side / along;
      add(jobs, {Problem::plane, scheme, size, number * size / c});
    }
}

}  // namespace

std::vector<PrecisionScheme> study_schemes(Problem problem) {
  std::vector<PrecisionScheme> schemes;
  const bool plane = problem == Problem::plane;
  if (problem == Problem::bar_cycle)  // the pulse of the thesis, for the schemes that matter
    return {thesis_scheme(),
            {"classical", "trapezoidal"},
            {"consistent", "trapezoidal"},
            {"consistent", "generalized_alpha 0.85"},
            {"cubic", "trapezoidal"},
            {"cubic", "trapezoidal", 1, true},
            {"cubic", "hht 0.1", 1, true},
            {"cubic", "generalized_alpha 0.85"},
            {"cubic", "generalized_alpha 0.8", 1, true},
            accurate_scheme(problem),
            {std::string(yardstick_law), std::string(central_differences)}};
  for (const char* integrator :
       {"thesis", "trapezoidal", "hht 0.1", "generalized_alpha 0.85", "generalized_alpha 0.8", "generalized_alpha 0"}) {
    schemes.push_back({"classical", integrator});
    schemes.push_back({"consistent", integrator});
    schemes.push_back({"consistent", integrator, 1, true});
    schemes.push_back({"consistent", integrator, plane ? 1.5 : 2});
    if (plane) continue;
    schemes.push_back({"cubic", integrator});
    schemes.push_back({"cubic", integrator, 1, true});
  }
  if (plane) schemes.push_back(explicit_scheme());
  if (!plane)
    for (const double springs : {20, 40, 100, 300})
      for (const char* integrator : {"thesis", "trapezoidal"})
        schemes.push_back({"classical", integrator, 1, false, springs});
  schemes.push_back({std::string(yardstick_law), std::string(central_differences)});
  if (!plane) schemes.push_back({std::string(yardstick_law), std::string(limit_differences)});
  return schemes;
}

std::vector<PrecisionJob> study_jobs() {
  std::vector<PrecisionJob> jobs;
  for (const Problem problem : {Problem::bar, Problem::bar_cycle}) {
    for (const PrecisionScheme& scheme : study_schemes(problem))
      scheme.is_yardstick() ? add_bar_yardstick(jobs, problem, scheme) : add_bar(jobs, problem, scheme);
  }
  for (const PrecisionScheme& scheme : study_schemes(Problem::plane)) add_plane(jobs, scheme);
  return jobs;
}

double planned_passes(const PrecisionJob& job) {
  if (job.problem == Problem::plane) return std::pow(2 * plane_half_side / job.size, 2) * plane_duration / job.dt;
  return thesis_reference().bar.length / job.size * bar_window() / job.dt;
}

}  // namespace verify
