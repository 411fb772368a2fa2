// A fixed number of steps of one small scene, for instruction counters: `dda-step-workload SCENE WARM_STEPS STEPS`.
//
// The counted steps are those under measured_steps(), so a counter can be switched on there and off again, and neither
// set-up nor the first factorization is in them. `dda-step-workload --facts` prints what counts depend on, one line.
#include <Eigen/Core>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/simulation/simulation.h"
#include "scenes.h"

namespace {

bool advance(dda::Simulation& simulation, long steps) {
  for (long i = 0; i < steps; ++i) {
    if (simulation.step() == dda::Status::ok) continue;
    std::fprintf(stderr, "step failed: %s\n", simulation.message().c_str());
    return false;
  }
  return true;
}

// A positive number of steps, or nothing.
std::optional<long> step_count(const char* text) {
  char* end = nullptr;
  const long steps = std::strtol(text, &end, 10);
  if (*end != '\0' || steps <= 0) return std::nullopt;
  return steps;
}

int print_facts() {
#ifdef NDEBUG
  constexpr const char* build = "optimized";
#else
  constexpr const char* build = "with assertions";
#endif
  std::printf("compiler %s, Eigen %d.%d.%d, solver %s, %s\n", __VERSION__, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
              EIGEN_MINOR_VERSION, DDA_CHOLESKY, build);
  return 0;
}

}  // namespace

// Not inlined and with a plain name, so that a profiler finds it.
extern "C" __attribute__((noinline)) bool measured_steps(dda::Simulation& simulation, long steps);
extern "C" bool measured_steps(dda::Simulation& simulation, long steps) { return advance(simulation, steps); }

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--facts") return print_facts();
  const std::optional<long> warm = argc == 4 ? step_count(argv[2]) : std::nullopt;
  const std::optional<long> steps = argc == 4 ? step_count(argv[3]) : std::nullopt;
  std::optional<dda::Model> model = argc == 4 ? dda::benchmarks::small_scene(argv[1]) : std::nullopt;
  if (!model || !warm || !steps) {
    std::fprintf(stderr, "usage: dda-step-workload SCENE WARM_STEPS STEPS | --facts\nscenes: %s\n",
                 dda::benchmarks::scene_names.data());
    return 2;
  }
  dda::Simulation simulation(std::move(*model));
  return advance(simulation, *warm) && measured_steps(simulation, *steps) ? 0 : 1;
}
