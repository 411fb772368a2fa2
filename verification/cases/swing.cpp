#include "verification/cases/swing.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "verification/harness/recorded_run.h"

namespace verify {
namespace {

double share_of(const dda::Simulation& simulation, const std::function<dda::Vec2(const dda::Vec2&)>& shape) {
  double sum = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    sum += simulation.state().displacement[i].head<2>().dot(shape(simulation.model().blocks[i].moments.centroid));
  return sum;
}

}  // namespace

double swing_frequency(dda::Simulation& simulation, const std::function<dda::Vec2(const dda::Vec2&)>& shape,
                       int zeros) {
  const double dt = simulation.model().stages.front().dt;
  double before = 0;
  int passed = 0;
  while (!simulation.finished()) {
    advance(simulation, 1);
    const double now = share_of(simulation, shape);
    if (before * now < 0 && ++passed == zeros) {
      const double time = simulation.state().time - dt * now / (now - before);
      return 2 / dt * std::tan(zeros * std::numbers::pi / time * dt / 2);
    }
    before = now;
  }
  throw std::runtime_error("the mode did not swing often enough");
}

}  // namespace verify
