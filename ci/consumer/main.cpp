// The least a program outside this repository does: read a scene, run it, look at the result. The bar falls freely, so
// its velocity after 0.01 s is -g t; 1e-9 of it is far above round-off over 100 steps, far below any wrong step.
#include <engine/scene/scene.h>
#include <engine/simulation/simulation.h>

#include <cmath>

int main() {
  dda::Simulation simulation(dda::parse_scene(R"({"dda": 1, "gravity": [0, -9.81],
    "materials": {"rock": {"density": 2500, "young": "40 GPa", "poisson": 0.25}},
    "blocks": {"bar": {"length": 4, "height": 1, "block_length": 2}}, "steps": {"dt": 1e-4, "duration": 0.01}})",
                                              "falling bar"));
  while (!simulation.finished()) {
    if (simulation.step() != dda::Status::ok) return 1;
  }
  const double velocity = simulation.state().velocity[0][1];
  return std::abs(velocity + 9.81 * 0.01) < 1e-9 * 9.81 * 0.01 ? 0 : 2;
}
