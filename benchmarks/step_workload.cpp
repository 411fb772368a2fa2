// A fixed number of steps of one small scene, for instruction counters:
// `dda-step-workload SCENE WARM_STEPS STEPS [PLANT]`. SCENE is a name or a scene file (*.json).
//
// The counted steps are those under measured_steps(), so a counter can be switched on there and off again, and neither
// set-up nor the warm steps are in them. Allocations and what the engine counts itself in these steps are printed as
// JSON. PLANT adds work to each step, by which it is tried whether such work would be noticed. `dda-step-workload
// --facts` prints what counts depend on, one line.
#include <fmt/format.h>

#include <Eigen/Core>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/core/allocation_counter.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "planted_work.h"
#include "scenes.h"

namespace {

using dda::benchmarks::PlantedWork;

bool advance(dda::Simulation& simulation, long steps, std::optional<PlantedWork>& planted) {
  for (long i = 0; i < steps; ++i) {
    if (simulation.step() != dda::Status::ok) {
      fmt::print(stderr, "step failed: {}\n", simulation.message());
      return false;
    }
    if (planted) planted->after_step(simulation);
  }
  return true;
}

// A number of steps, or nothing.
std::optional<long> step_count(const char* text) {
  char* end = nullptr;
  const long steps = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || steps < 0) return std::nullopt;
  return steps;
}

int print_facts() {
#ifdef NDEBUG
  constexpr const char* build = "optimized";
#else
  constexpr const char* build = "with assertions";
#endif
  fmt::print("compiler {}, Eigen {}.{}.{}, solver {}, {}\n", __VERSION__, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
             EIGEN_MINOR_VERSION, DDA_CHOLESKY, build);
  return 0;
}

void print_counts(const dda::Counters& before, const dda::Counters& after, long allocations) {
  std::string text = fmt::format("{{\"allocations\": {}", allocations);
  for (const dda::CounterField& field : dda::counter_fields)
    text += fmt::format(", \"{}\": {}", field.name, after.*field.value - before.*field.value);
  fmt::print("{}}}\n", text);
}

std::optional<dda::Model> model_of(const std::string& scene) {
  if (scene.ends_with(".json")) return dda::read_scene(scene);
  return dda::benchmarks::small_scene(scene);
}

int complain() {
  fmt::print(stderr,
             "usage: dda-step-workload SCENE WARM_STEPS STEPS [PLANT] | --facts\nscenes: {} FILE.json\nplants: {}\n",
             dda::benchmarks::scene_names, dda::benchmarks::plant_names);
  return 2;
}

}  // namespace

// Not inlined and with a plain name, so that a profiler finds it.
extern "C" __attribute__((noinline)) bool measured_steps(dda::Simulation& simulation, long steps,
                                                         std::optional<PlantedWork>& planted);
extern "C" bool measured_steps(dda::Simulation& simulation, long steps, std::optional<PlantedWork>& planted) {
  return advance(simulation, steps, planted);
}

namespace {

int count_steps(dda::Model model, long warm, long steps, std::optional<dda::benchmarks::Plant> plant) {
  dda::Simulation simulation(std::move(model));
  std::optional<PlantedWork> planted;
  if (!advance(simulation, warm, planted)) return 1;
  if (plant) planted.emplace(*plant, simulation);
  const dda::Counters before = simulation.counters();
  const long allocations_before = dda::allocations_so_far();
  if (!measured_steps(simulation, steps, planted)) return 1;
  const long allocations = dda::allocations_so_far() - allocations_before;
  print_counts(before, simulation.counters(), allocations);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--facts") return print_facts();
  if (argc < 4 || argc > 5) return complain();
  const std::optional<long> warm = step_count(argv[2]);
  const std::optional<long> steps = step_count(argv[3]);
  const auto plant = argc == 5 ? dda::benchmarks::plant_named(argv[4]) : std::nullopt;
  std::optional<dda::Model> model = model_of(argv[1]);
  if (!model || !warm || !steps || (argc == 5 && !plant)) return complain();
  return count_steps(std::move(*model), *warm, *steps, plant);
}
