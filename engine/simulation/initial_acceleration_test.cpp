// Stages that begin out of balance, with steps that do not resolve what is let go.
#include <gtest/gtest.h>

#include <utility>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// A block that hangs in the air with a stress that nothing holds, as one that was held while others settled. Its
// strains swing a hundred times a step and more, so that its first acceleration lasts for next to nothing of that:
// taken for that of a step it was 1e7 times the energy of the block (a splinter of 0.1 mm of a random scene).
TEST(InitialAcceleration, StressThatIsLetGoBringsNoMoreThanItStored) {
  for (const double size : {1e-4, 1e-2, 1.0})
    for (const double rho : {0.0, 0.5, 0.8}) {
      Model model;
      model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
      model.joints = {JointMaterial{}};
      model.blocks = {rectangle("far away", 10, 0, 1, 1), rectangle("splinter", 0, 0, size, size)};
      model.blocks[1].initial_stress = {-1e6, 2e6, 5e5};
      model.stages = {stage_of(generalized_alpha_integrator(rho), 1e-3, 20, Kinematics::finite)};
      Simulation simulation = simulation_of(std::move(model));
      const double stored = simulation.energy().initial_strain;
      for (int step = 0; step < 20; ++step) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        EXPECT_LT(simulation.energy().kinetic + simulation.energy().strain, stored * (1 + 1e-9))
            << "size " << size << ", rho " << rho << ", step " << step;
      }
    }
}

}  // namespace
}  // namespace dda
