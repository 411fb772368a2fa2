#include "verification/harness/recorded_run.h"

#include <fmt/format.h>

#include <cstddef>
#include <ctime>
#include <stdexcept>

#include "engine/simulation/probes.h"
#include "engine/simulation/run_so_far.h"

namespace verify {
namespace {

void keep(const dda::Probes& probes, const dda::Simulation& simulation, std::vector<double>& sample,
          std::vector<std::vector<double>>& histories) {
  probes.sample(simulation, sample);
  for (std::size_t i = 0; i < sample.size(); ++i) histories[i].push_back(sample[i]);
}

void step(dda::Simulation& simulation) {
  const dda::Status status = simulation.step();
  if (status == dda::Status::ok) return;
  throw std::runtime_error(fmt::format("\"{}\" stopped at t = {:g} s: {}", simulation.model().title,
                                       simulation.state().time, simulation.message()));
}

}  // namespace

void advance(dda::Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) step(simulation);
}

void advance_to_end(dda::Simulation& simulation) {
  while (!simulation.finished()) step(simulation);
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

RecordedRun record_run(const dda::Model& model) {
  RecordedRun run;
  const double start = cpu_seconds();
  dda::Simulation simulation(model);
  const dda::Probes probes(simulation);
  run.setup_cpu_s = cpu_seconds() - start;
  run.dt = model.stages.front().dt;
  run.solver = simulation.plan().solver;
  std::vector<double> sample(probes.size());
  run.histories.resize(probes.size());
  for (std::vector<double>& history : run.histories)
    history.reserve(static_cast<std::size_t>(steps_in_all_stages(simulation)) + 1);

  keep(probes, simulation, sample, run.histories);
  const double first_step = cpu_seconds();
  while (!simulation.finished()) {
    step(simulation);
    keep(probes, simulation, sample, run.histories);
  }
  run.cpu_s = cpu_seconds() - first_step;
  run.counters = simulation.counters();
  run.energy = simulation.energy();
  return run;
}

}  // namespace verify
