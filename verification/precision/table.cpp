#include "verification/precision/table.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <set>

namespace verify {
namespace {

std::vector<Measured> filtered(const std::vector<Measured>& all,
                               const std::function<bool(const PrecisionJob&)>& wanted) {
  std::vector<Measured> runs;
  for (const Measured& measured : all)
    if (measured.runs > 0 && std::isfinite(measured.result.error) && wanted(measured.job)) runs.push_back(measured);
  return runs;
}

std::set<std::string> keys_on_front(const std::vector<Measured>& all, Cost cost) {
  std::set<std::string> keys;
  for (const Problem problem : {Problem::bar, Problem::bar_cycle, Problem::plane}) {
    const std::vector<Measured> runs = engine_runs(all, problem);
    for (const std::size_t i : pareto_front(points_of(runs, cost))) keys.insert(runs[i].job.key());
  }
  return keys;
}

}  // namespace

double error_of(const Measured& measured, Norm norm) {
  return norm == Norm::l2 ? measured.result.error : measured.result.reading;
}

double cost_of(const Measured& measured, Cost cost) {
  return cost == Cost::cpu ? measured.result.cpu_s : measured.result.passes();
}

std::vector<Measured> runs_of(const std::vector<Measured>& all, Problem problem) {
  return filtered(all, [&](const PrecisionJob& job) { return job.problem == problem; });
}

std::vector<Measured> runs_of(const std::vector<Measured>& all, Problem problem, const PrecisionScheme& scheme) {
  return filtered(all, [&](const PrecisionJob& job) { return job.problem == problem && job.scheme == scheme; });
}

std::vector<Measured> engine_runs(const std::vector<Measured>& all, Problem problem) {
  return filtered(all, [&](const PrecisionJob& job) { return job.problem == problem && job.scheme.is_engine(); });
}

std::vector<CostAndError> points_of(const std::vector<Measured>& runs, Cost cost, Norm norm) {
  std::vector<CostAndError> points;
  for (const Measured& measured : runs) points.push_back({cost_of(measured, cost), error_of(measured, norm)});
  return points;
}

std::string to_csv(const std::vector<Measured>& all) {
  const std::set<std::string> by_cpu = keys_on_front(all, Cost::cpu);
  const std::set<std::string> by_passes = keys_on_front(all, Cost::passes);
  std::string text =
      "problem,law,integrator,strain_inertia,corrected,spring_over_young,size_m,dt_s,cells,steps,solves,solver_"
      "iterations,passes,error,"
      "reading_error,cpu_s,runs,on_cpu_front,on_passes_front\n";
  for (const Measured& measured : all) {
    const auto& [job, result, runs, failure] = measured;
    text += fmt::format("{},{},{},{:g},{},{:g},{:.9g},{:.9g},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{}\n",
                        name_of(job.problem), job.scheme.law, job.scheme.integrator, job.scheme.strain_inertia,
                        job.scheme.corrected, job.scheme.spring_over_young, job.size, job.dt, result.cells,
                        result.steps, result.solves, result.iterations, result.passes(), result.error, result.reading,
                        result.cpu_s, runs, by_cpu.contains(job.key()), by_passes.contains(job.key()));
  }
  return text;
}

}  // namespace verify
