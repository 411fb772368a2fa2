// What the wall of docs/examples that rocks before a face costs.
#include <gtest/gtest.h>

#include <string>

#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// Measured: 6.1 passes a step, 5.1 where the joints are springs. It took 13.6 while every step that led away from the
// balance was halved, though the next whole one would have led straight to it.
TEST(RockingWall, TakesFewPasses) {
  Simulation simulation(read_scene(std::string(DDA_EXAMPLES) + "/shaken_wall.json"));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  const Counters counters = simulation.counters();
  EXPECT_LE(counters.open_close_iterations, 8 * counters.steps);
}

}  // namespace
}  // namespace dda
