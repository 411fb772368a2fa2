// Stages that begin out of balance, with steps that do not resolve what is let go.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
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
      const double stored = simulation.energy().initial.strain;
      for (int step = 0; step < 20; ++step) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        EXPECT_LT(simulation.energy().kinetic + simulation.energy().strain, stored * (1 + 1e-9))
            << "size " << size << ", rho " << rho << ", step " << step;
      }
    }
}

// Boxes side by side on a smooth slope, which stuck to it while they settled, and press against each other. They all
// slide with g sin(dip) from the first moment on, steps long against what lets go between them or not: held by
// neighbours that were taken to stand still they began half a step late.
TEST(InitialAcceleration, ARowThatBeginsToSlideDoesNotHoldItselfBack) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected})
    for (const double dt : {1e-4, 1e-3, 2e-3, 1e-2}) {
      Model model;
      model.materials = {{"rock", 2600, 5e9, 0.2, PlaneState::stress}};
      model.joints = {JointMaterial{}};
      model.joints[0].law = law;
      model.blocks = {rectangle("slope", -5, -1, 15, 1)};
      model.held_blocks.resize(1);
      for (int i = 0; i < 4; ++i)
        model.blocks.push_back(rectangle("box " + std::to_string(i), 1.1 * i, 0, 1.1, 0.5 + 0.1 * i));
      const double dip = 0.5;
      model.gravity = 9.81 * Vec2(std::sin(dip), -std::cos(dip));
      Stage settle = stage_of(static_integrator(), 0, 0, Kinematics::finite);  // finds its own steps
      settle.equilibrium = 1e-9;
      settle.unlimited_strength = true;
      model.stages = {settle, stage_of(generalized_alpha_integrator(0), dt, 3, Kinematics::finite)};
      Simulation simulation = simulation_of(std::move(model));
      while (simulation.state().time == 0) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      double mass = 0, momentum = 0;
      for (int i = 0; i < 4; ++i) {
        mass += 0.5 + 0.1 * i;
        momentum += (0.5 + 0.1 * i) * simulation.state().velocity[static_cast<std::size_t>(i + 1)](0);
      }
      // What turns the boxes by 1e-5 in settling turns their weight by as much.
      EXPECT_NEAR(momentum / mass / (9.81 * std::sin(dip) * dt), 1, 1e-4) << dt;
    }
}

}  // namespace
}  // namespace dda
