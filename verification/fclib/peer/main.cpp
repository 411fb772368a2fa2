// dda-fclib: steps of runs as files of FCLIB, and the engine's solver beside those of Siconos.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <exception>
#include <limits>
#include <optional>
#include <string>

#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "engine/solve/contact_solver.h"
#include "verification/fclib/peer/fclib_file.h"
#include "verification/fclib/peer/siconos.h"
#include "verification/fclib/step_of_run.h"

namespace verify {
namespace {

struct Command {
  std::string input, output;
  int steps = 0;
  int unknowns = 6;
  double accuracy = 1e-8;
  double rigid = 1e6;
};

struct Answer {
  std::string solver, said;
  Eigen::VectorXd forces;
  std::int64_t passes = 0;
  double cpu_s = 0, residual = 0;
};

OwnedStep step_after(const std::string& scene, int steps) {
  dda::Simulation run(dda::read_scene(scene));
  for (int i = 0; i < steps && !run.finished(); ++i)
    if (run.step() != dda::Status::ok) throw std::runtime_error(scene + ": " + run.message());
  return next_step(run);
}

Answer ask_engine(const OwnedStep& step, const LocalFrictionProblem& local) {
  const std::clock_t begin = std::clock();
  dda::Costs costs;
  dda::ContactSolver solver(costs);
  const bool is_iterative = step.base.size() > 400;
  const double chi = is_iterative ? 100 : std::numeric_limits<double>::infinity();
  solver.begin(step.base, is_iterative ? dda::SolverKind::pcg : dda::SolverKind::cholesky, chi);
  const dda::Status status = solver.solve(step.problem()).status;
  Answer answer{"dda (ContactSolver)",
                std::string(to_string(status)),
                forces_of(step.problem(), solver.contacts()),
                costs.counters.open_close_iterations,
                0,
                0};
  answer.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  answer.residual = residual(local, answer.forces);
  return answer;
}

// With the loosest of its tolerances that brings the residual below what is asked for; the last answer where none does.
Answer ask(const PeerSolver& solver, const LocalFrictionProblem& local, double accuracy) {
  Answer last;
  for (double tolerance = 1e-4; tolerance > 1e-14; tolerance /= 10) {
    const PeerAnswer answer = ask_siconos(solver, local, tolerance);
    const std::string said = answer.is_there ? "ok" : "not_converged";
    last = {solver.name, said, answer.forces, answer.iterations, answer.cpu_s, residual(local, answer.forces)};
    if (last.residual <= accuracy || !answer.is_there) return last;
  }
  return last;
}

void print(const Answer& answer, double accuracy, const Eigen::VectorXd& first) {
  const bool is_accurate = std::isfinite(answer.residual) && answer.residual <= accuracy;
  const double apart = (answer.forces - first).cwiseAbs().maxCoeff() / first.cwiseAbs().maxCoeff();
  fmt::print("| {} | {} | {} | {:.3g} | {:.1e} | {:.1e} |\n", answer.solver, is_accurate ? "yes" : "no, " + answer.said,
             answer.passes, 1e3 * answer.cpu_s, answer.residual, apart);
  std::fflush(stdout);
}

int compare(const OwnedStep& step, const Command& command) {
  const std::clock_t begin = std::clock();
  const LocalFrictionProblem local = local_problem(friction_problem(step.problem()));
  const double forming = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  fmt::print("{} blocks, {} contacts; W has {} numbers and takes {:.3g} ms to form\n\n", step.base.size(),
             local.friction.size(), local.delassus.nonZeros(), 1e3 * forming);
  fmt::print(
      "| solver | residual <= {:g} | passes | CPU ms | residual | forces apart from dda's "
      "|\n|---|---|---|---|---|---|\n",
      command.accuracy);
  const Answer engine = ask_engine(step, local);
  print(engine, command.accuracy, engine.forces);
  for (const PeerSolver& solver : siconos_solvers())
    if (local.friction.size() <= solver.contacts)
      print(ask(solver, local, command.accuracy), command.accuracy, engine.forces);
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app("Steps of runs in FCLIB's form, and the engine's solver beside those of Siconos.");
  app.require_subcommand(1);
  Command command;
  CLI::App* writes = app.add_subcommand("write", "the problem of the step after STEPS of a scene, as a file of FCLIB");
  CLI::App* compares = app.add_subcommand("compare", "that problem, by the engine and by Siconos");
  CLI::App* solves = app.add_subcommand("solve", "a global problem of two dimensions in a file of FCLIB, by both");
  for (CLI::App* of_scene : {writes, compares}) {
    of_scene->add_option("scene", command.input, "scene file")->required();
    of_scene->add_option("steps", command.steps, "steps before it")->required();
  }
  writes->add_option("file", command.output, "file to write (HDF5)")->required();
  solves->add_option("file", command.input, "file of FCLIB (HDF5)")->required();
  solves->add_option("--unknowns", command.unknowns, "of a block: 6, or 3 where blocks are rigid")
      ->capture_default_str();
  solves->add_option("--rigid", command.rigid, "stiffness that stands for none given, over that of W")
      ->capture_default_str();
  for (CLI::App* of_both : {compares, solves})
    of_both->add_option("--residual", command.accuracy, "that all are to reach")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if (*compares) return compare(step_after(command.input, command.steps), command);
  if (*solves) return compare(step_of(read_fclib(command.input), command.unknowns, command.rigid), command);
  write_fclib(friction_problem(step_after(command.input, command.steps).problem()), command.input, command.output);
  return 0;
}

}  // namespace
}  // namespace verify

int main(int argc, char** argv) {
  try {
    return verify::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "dda-fclib: {}\n", error.what());
    return 2;
  }
}
