// What threads share of the search for contacts and of their renewal gives the bits of one thread.
#include <gtest/gtest.h>

#include "engine/core/parallel.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// Dry blocks enough for every loop to be shared, struck at a corner so hard that rows slide and part.
Model struck_grid(int side, InterfaceLaw law) {
  JointMaterial joint;
  joint.name = "dry";
  joint.law = law;
  joint.friction_angle = 0.5;
  Model model = grid_of(side, joint, Pattern::running_bond);
  model.gravity = {0, -9.81};
  model.edge_loads = {{0, {0, 0}, {0, 0.5}, {3e7, 2e7}, Constant{}}};
  model.stages = {stage_of(generalized_alpha_integrator(0.8), 2e-4, 12, Kinematics::finite)};
  finish_model(model);
  return model;
}

void expect_bits_of_one_thread(const Model& model, int steps) {
  const auto after = [&](int threads) {
    const ThreadsInUse in_use(threads);
    Simulation simulation(model);
    run(simulation, steps);
    EXPECT_GT(simulation.counters().contact_searches, steps / 2 - 1);
    return memory_of(simulation);
  };
  const auto alone = after(1);
  for (const int threads : {2, 4}) EXPECT_TRUE(after(threads) == alone) << threads << " threads";
}

TEST(SharedContacts, HaveTheBitsOfOneThread) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected})
    expect_bits_of_one_thread(struck_grid(30, law), 12);
}

// From 8,192 contacts on their sums are taken by pieces.
TEST(SharedContacts, HaveTheBitsOfOneThreadWhereSumsAreTakenByPieces) {
  expect_bits_of_one_thread(struck_grid(56, InterfaceLaw::projected), 3);
}

}  // namespace
}  // namespace dda
