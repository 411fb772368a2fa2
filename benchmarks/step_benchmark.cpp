// One whole warm step. Counters are means over the first `counted_steps` steps of the measurement.
#include <benchmark/benchmark.h>

#include <utility>

#include "engine/core/allocation_counter.h"
#include "engine/simulation/simulation.h"
#include "scenes.h"

namespace dda::benchmarks {
namespace {

constexpr int counted_steps = 20;

bool advance(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    if (simulation.step() != Status::ok) return false;
  }
  return true;
}

void set_counters(benchmark::State& state, const Simulation& simulation, const Counters& before, long allocations) {
  const Counters after = simulation.counters();
  const auto per_step = [&](auto change) { return static_cast<double>(change) / counted_steps; };
  state.counters["blocks"] = static_cast<double>(simulation.model().blocks.size());
  state.counters["contacts"] = static_cast<double>(simulation.contacts().interfaces.size());
  state.counters["factorizations"] = per_step(after.factorizations - before.factorizations);
  state.counters["iterations"] = per_step(after.solver_iterations - before.solver_iterations);
  state.counters["passes"] = per_step(after.open_close_iterations - before.open_close_iterations);
  state.counters["allocations"] = per_step(allocations);
}

void run_steps(benchmark::State& state, Model model, int warm_steps) {
  const auto blocks = static_cast<std::int64_t>(model.blocks.size());
  Simulation simulation(std::move(model));
  bool ok = advance(simulation, warm_steps);
  const Counters before = simulation.counters();
  const long allocations = allocations_so_far();
  ok = ok && advance(simulation, counted_steps);
  set_counters(state, simulation, before, allocations_so_far() - allocations);
  if (!ok) state.SkipWithError(simulation.message().c_str());
  for (auto _ : state) {
    if (simulation.step() != Status::ok) state.SkipWithError(simulation.message().c_str());
  }
  state.SetItemsProcessed(state.iterations() * blocks);
}

// The wave is past the end of the bar after 2,300 steps; from then on every block moves.
constexpr int steps_to_fill_bar = 2500;

void bar_step(benchmark::State& state, Joints joints) {
  run_steps(state, bar(static_cast<int>(state.range(0)), joints), steps_to_fill_bar);
}

void grid_step(benchmark::State& state, Joints joints, Kinematics kinematics) {
  run_steps(state, grid(static_cast<int>(state.range(0)), joints, kinematics), 3);
}

// After the wall settled; contacts that carry little keep opening and closing.
void dry_wall_step(benchmark::State& state) {
  run_steps(state, dry_wall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))), 100);
}

void bar_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMicrosecond)->Arg(50)->Arg(100)->Arg(200);
}

void grid_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMicrosecond)->Arg(20)->Arg(100);
}

BENCHMARK_CAPTURE(bar_step, consistent, Joints::consistent)->Name("step/bar_consistent")->Apply(bar_sizes);
BENCHMARK_CAPTURE(bar_step, cubic, Joints::cubic)->Name("step/bar_cubic")->Apply(bar_sizes);
BENCHMARK_CAPTURE(bar_step, springs, Joints::strong_springs)->Name("step/bar_springs_judged")->Apply(bar_sizes);
BENCHMARK_CAPTURE(grid_step, consistent, Joints::consistent, Kinematics::small)
    ->Name("step/grid_consistent")
    ->Apply(grid_sizes);
BENCHMARK_CAPTURE(grid_step, springs, Joints::strong_springs, Kinematics::small)
    ->Name("step/grid_springs_judged")
    ->Apply(grid_sizes);
BENCHMARK_CAPTURE(grid_step, finite, Joints::strong_springs, Kinematics::finite)
    ->Name("step/grid_springs_finite")
    ->Apply(grid_sizes);
BENCHMARK(dry_wall_step)->Name("step/dry_wall")->Unit(benchmark::kMicrosecond)->Args({10, 10});

}  // namespace
}  // namespace dda::benchmarks
