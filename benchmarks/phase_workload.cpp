// Steps of a scene with callgrind's counts written out wherever one phase ends and another begins:
// `dda-phase-workload SCENE WARM_STEPS STEPS [PHASE NUMBER]`, for `ci/perf phases`.
//
// The clock of the phases (engine/core/phase_clock.h) is given one that ticks at each look and has callgrind write what
// it counted since the one before. Printed is the phase of every stretch between two ticks, by its place among
// phase_names. PHASE and NUMBER plant a slowdown: so many rounds of arithmetic in that phase after each step.
#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/phase_clock.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "scenes.h"

namespace {

std::int64_t ticks = 0;

std::int64_t tick() {
  CALLGRIND_DUMP_STATS;
  return ticks++;
}

struct Plant {
  dda::Phase phase = dda::Phase::other;
  long rounds = 0;
};

void work_in_vain(const Plant& plant) {
  if (plant.rounds == 0) return;
  const dda::PhaseScope scope(plant.phase);
  volatile double sum = 0;
  for (long i = 0; i < plant.rounds; ++i) sum = sum + static_cast<double>(i);
}

// Events come in the order of their ends, so those within others come first.
std::vector<int> phases_of_stretches(const dda::PhaseClock& clock) {
  std::vector<int> phases(static_cast<std::size_t>(ticks), -1);
  for (const dda::PhaseEvent& event : clock.events())
    for (std::int64_t i = event.begin; i < event.begin + event.duration; ++i)
      if (int& phase = phases[static_cast<std::size_t>(i)]; phase < 0) phase = static_cast<int>(event.phase);
  for (int& phase : phases)
    if (phase < 0) phase = static_cast<int>(dda::Phase::other);
  return phases;
}

bool advance(dda::Simulation& simulation, long steps, const Plant& plant) {
  for (long i = 0; i < steps; ++i) {
    if (simulation.step() != dda::Status::ok) {
      fmt::print(stderr, "step failed: {}\n", simulation.message());
      return false;
    }
    work_in_vain(plant);
  }
  return true;
}

std::optional<dda::Model> model_of(const std::string& scene) {
  if (scene.ends_with(".json")) return dda::read_scene(scene);
  return dda::benchmarks::small_scene(scene);
}

}  // namespace

int main(int argc, char** argv) {
  std::optional<dda::Model> model = argc == 4 || argc == 6 ? model_of(argv[1]) : std::nullopt;
  if (!model) {
    fmt::print(stderr, "usage: dda-phase-workload SCENE WARM_STEPS STEPS [PHASE NUMBER]\n");
    return 2;
  }
  Plant plant;
  if (argc == 6) plant = {static_cast<dda::Phase>(std::atoi(argv[4])), std::atol(argv[5])};
  dda::Simulation simulation(std::move(*model));
  if (!advance(simulation, std::atol(argv[2]), {})) return 1;
  const dda::PhaseClock clock(tick);
  if (!advance(simulation, std::atol(argv[3]), plant)) return 1;
  CALLGRIND_DUMP_STATS;
  if (clock.events_left_out() > 0) {
    fmt::print(stderr, "more phases than the clock remembers: take fewer steps\n");
    return 1;
  }
  std::vector<std::string> names;
  for (const dda::PhaseName& each : dda::phase_names) names.push_back(fmt::format("\"{}\"", each.name));
  fmt::print("{{\"names\": [{}], \"phases\": [{}]}}\n", fmt::join(names, ", "),
             fmt::join(phases_of_stretches(clock), ", "));
  return 0;
}
