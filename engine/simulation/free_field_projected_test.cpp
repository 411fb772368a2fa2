// Free-field sides of rock with projected joints: the ties of the columns are what these joints are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "engine/simulation/free_field_models.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

using namespace free_field;

constexpr double pressure = 5e6;  // Pa, in situ: a hundred times what the shaking makes

// The shaken grid under a stress in situ of `pressure` up and down and `across` sideways, which a load on top bears.
Model pressed_grid(const JointMaterial& joint, double across) {
  Model model = shaken_grid(joint);
  for (Block& block : model.blocks) block.initial_stress = {-across, -pressure, 0};
  for (int column = 0; column < columns; ++column)
    model.edge_loads.push_back(
        {(rows - 1) * columns + column, {column + 1.0, rows}, {1.0 * column, rows}, {0, -pressure}, Constant{}});
  return model;
}

JointMaterial bonded_projected() { return bond(InterfaceLaw::projected); }

// Layers of any rock and of joints, dry or bonded, with and without a compliance of their own.
Model random_layers(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.2, 1);
  JointMaterial joint = seed % 3 == 0 ? bonded_projected() : dry_projected(0.3 + share(random));
  if (seed % 2 == 0) {
    joint.normal_stiffness = 5e10 * share(random);
    joint.shear_stiffness = share(random) * joint.normal_stiffness;
  }
  Model model = pressed_grid(joint, pressure * (0.5 + share(random)));
  model.materials.assign(rows, rock());
  for (Material& material : model.materials) {
    material.young *= share(random);
    material.density *= share(random);
    material.poisson = 0.45 * share(random);
  }
  for (int block = 0; block < rows * columns; ++block) model.blocks[at(block)].material = block / columns;
  if (seed % 3 == 0) model.stages[0].material_damping = {.mass = 20 * share(random), .stiffness = 1e-4 * share(random)};
  model.stages[0].integrator = seed % 4 == 1 ? thesis_integrator() : generalized_alpha_integrator(0.8);
  return model;
}

// Every row moves as the columns do, whatever its rock is: 1e-9 is what the passes leave of the balance, 1e-10 of the
// largest force, beside velocities whose stresses are a hundredth of it.
TEST(FreeFieldProjected, LayersGoWithTheColumns) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Simulation simulation = simulation_of(random_layers(seed));
    EXPECT_LT(difference_from_columns(simulation, 100), 1e-9) << "seed " << seed;
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11) << "seed " << seed;
  }
}

// Rock at rest beside columns at rest: nothing in either knows that it is not endless.
TEST(FreeFieldProjected, RockThatNobodyTouchesStaysStill) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (unsigned seed = 0; seed < 12; ++seed) {
      Model model = random_layers(seed);
      std::get<SineCycles>(model.held_blocks[0].history).start = 1000;
      for (Stage& stage : model.stages) stage.kinematics = kinematics;
      model.stages[0].material_damping = {};
      Simulation simulation = simulation_of(std::move(model));
      const double speed = pressure / 1.2e7;  // of a side that nothing held
      run(simulation, 100);
      for (const Vec6& velocity : simulation.state().velocity)
        EXPECT_LT(velocity.cwiseAbs().maxCoeff(), 1e-10 * speed) << "seed " << seed;
    }
}

}  // namespace
}  // namespace dda
