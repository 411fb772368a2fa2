#include "verification/precision/summary.h"

#include <fmt/format.h>

#include <array>

namespace verify {
namespace {

constexpr std::array wanted_errors = {0.1, 0.03, 0.01, 0.003, 0.001};

std::string cell(const std::vector<Measured>& runs, Norm norm, double error) {
  const auto by_cpu = cheapest_run(runs, Cost::cpu, norm, error);
  if (!by_cpu) return " - |";
  const auto by_passes = cheapest_run(runs, Cost::passes, norm, error);
  const PrecisionJob& job = by_cpu->job;
  return fmt::format(" {:.3g} ms, {:.2g} passes ({:.3g} m, {:.2g} ms) |", 1e3 * by_cpu->result.cpu_s,
                     by_passes->result.passes(), job.size, 1e3 * job.dt);
}

std::string row(const std::string& name, const std::vector<Measured>& runs, Norm norm) {
  std::string text = "| " + name + " |";
  for (const double error : wanted_errors) text += cell(runs, norm, error);
  return text + "\n";
}

std::string gain_row(const std::vector<Measured>& all, Problem problem, Cost cost, Norm norm) {
  std::string text = fmt::format("| thesis over accurate, {} |", cost == Cost::cpu ? "CPU time" : "passes");
  for (const double error : wanted_errors) {
    const std::optional<double> times = gain(all, problem, cost, norm, error);
    text += times ? fmt::format(" {:.3g} |", *times) : " - |";
  }
  return text + "\n";
}

// Schemes in the order of their first run.
std::vector<PrecisionScheme> schemes_of(const std::vector<Measured>& runs) {
  std::vector<PrecisionScheme> schemes;
  for (const Measured& measured : runs) {
    bool known = false;
    for (const PrecisionScheme& scheme : schemes) known = known || scheme == measured.job.scheme;
    if (!known) schemes.push_back(measured.job.scheme);
  }
  return schemes;
}

std::string table_of(const std::vector<Measured>& all, Problem problem, Norm norm) {
  const std::vector<Measured> runs = runs_of(all, problem);
  if (runs.empty()) return "";
  std::string text =
      fmt::format("## {}, {}\n\n| scheme | 10 % | 3 % | 1 % | 0.3 % | 0.1 % |\n|---|---|---|---|---|---|\n",
                  name_of(problem), norm == Norm::l2 ? "relative L2 norm" : "readings of velocity and amplitude");
  for (const PrecisionScheme& scheme : schemes_of(runs)) {
    std::string name = scheme.name();
    if (scheme == accurate_scheme(problem)) name += " (accurate default)";
    if (scheme == thesis_scheme()) name += " (thesis)";
    text += row(name, runs_of(all, problem, scheme), norm);
  }
  text += row("cheapest of the engine", engine_runs(all, problem), norm);
  return text + gain_row(all, problem, Cost::cpu, norm) + gain_row(all, problem, Cost::passes, norm) + "\n";
}

}  // namespace

std::optional<Measured> cheapest_run(const std::vector<Measured>& runs, Cost cost, Norm norm, double error) {
  const auto found = cheapest(points_of(runs, cost, norm), error);
  return found ? std::optional(runs[*found]) : std::nullopt;
}

std::optional<double> gain(const std::vector<Measured>& all, Problem problem, Cost cost, Norm norm, double error) {
  const auto thesis = cheapest_run(runs_of(all, problem, thesis_scheme()), cost, norm, error);
  const auto accurate = cheapest_run(runs_of(all, problem, accurate_scheme(problem)), cost, norm, error);
  if (!thesis || !accurate) return std::nullopt;
  return cost_of(*thesis, cost) / cost_of(*accurate, cost);
}

std::string summary_of(const std::vector<Measured>& all) {
  std::string text =
      "# Work against precision\n\nCheapest run with at most that error: CPU time (block size, time step of that run), "
      "and "
      "fewest passes over a cell.\n\n";
  for (const Problem problem : {Problem::bar, Problem::bar_cycle}) {
    text += table_of(all, problem, Norm::l2);
    text += table_of(all, problem, Norm::reading);
  }
  text += table_of(all, Problem::plane, Norm::l2);
  return text;
}

}  // namespace verify
