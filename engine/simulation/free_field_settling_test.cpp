// Level rock that settles between free-field sides in static stages, and such sides that begin where it has settled.
// The oracle is that of level ground: everything above a place rests on it, and nothing strains sideways.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "engine/simulation/free_field_models.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

using namespace free_field;

constexpr double gravity = 9.81;

// Ground of one rock by lot on a held base, that settles from nothing in steps of `dt` over its height over the speed
// of a bar's wave.
struct Ground {
  Model model;
  double weight = 0, across = 0;  // Pa for each m of depth; and how much of it presses sideways
};

Ground level_ground(unsigned seed, const JointMaterial& joint, double dt, Kinematics kinematics, int first_stage = 0) {
  std::mt19937 random(seed);
  const auto share = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  Ground ground;
  ground.model = shaken_grid(joint);
  Model& model = ground.model;
  Material& soil = model.materials[0];
  soil.plane = PlaneState::strain;
  soil.young = std::pow(10, share(8, 10.3));
  soil.poisson = share(0.15, 0.4);
  soil.density = share(1900, 2600);
  model.materials[1] = soil;
  model.held_blocks = {HeldBlock{}};
  model.held_blocks[0].block = rows * columns;
  model.gravity = {0, -gravity};
  model.viscous_edges.clear();
  model.free_field_sides.clear();
  add_sides(first_stage, model);
  const double impedance = std::sqrt(soil.density * soil.young);
  for (ViscousEdge& edge : model.viscous_edges) {
    edge.normal_impedance = 1.1 * impedance;
    edge.shear_impedance = 0.6 * impedance;
  }
  model.stages = {stage_of(static_integrator(), dt * rows / std::sqrt(soil.young / soil.density), 3000, kinematics)};
  model.stages[0].equilibrium = 1e-10;
  ground.weight = soil.density * gravity;
  ground.across = soil.poisson / (1 - soil.poisson);
  return ground;
}

void settle(Simulation& simulation, std::size_t stages) {
  while (simulation.system().clock.stage < stages && !simulation.finished())
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

// Largest error of a block's stress, of its pressure.
double error_of(const Ground& ground, const State& state) {
  double most = 0;
  for (int block = 0; block < rows * columns; ++block) {
    const double above = -ground.weight * (rows - block / columns - 0.5);
    const Vec3 expected(ground.across * above, above, 0);
    most = std::max(most, (state.stress[at(block)] - expected).norm() / std::abs(above));
  }
  return most;
}

// Dashpots of the sides held the rock back by what the columns, which are at rest between static steps, went ahead in
// each: dry joints slid and gaped on the way, and stayed so. In steps of a tenth of the way of a wave the rock falls
// before it rests on anything, so that dry joints near the top gape and close again with a little shear, between
// rollers as well (up to 0.2 %).
TEST(FreeFieldSettling, LeavesTheStressOfLevelGroundWhateverTheStep) {
  for (const bool dry : {true, false})
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
      for (const double dt : {0.1, 1.0, 3.0, 10.0, 1000.0})
        for (unsigned seed = 0; seed < 6; ++seed) {
          JointMaterial joint = dry_projected(0.55 + 0.05 * seed);
          if (!dry) joint.cohesion = joint.tensile_strength = 1e9;
          const Ground ground = level_ground(seed, joint, dt, kinematics);
          Simulation simulation = simulation_of(ground.model);
          settle(simulation, 1);
          const double strain = ground.weight * rows / ground.model.materials[0].young;
          const double by_falling = dry && dt < 1 ? 3e-3 : 0;
          EXPECT_LT(error_of(ground, simulation.state()),
                    by_falling + (kinematics == Kinematics::small ? 1e-7 : 3 * strain))
              << (dry ? "dry" : "glued") << (kinematics == Kinematics::small ? " small" : " finite") << " dt " << dt
              << " seed " << seed;
          EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
        }
}

// Held sideways while it settles, beside a free field from then on: nothing comes that was not there before. In finite
// kinematics what joints of the sides do to strains acted before the sides did, and was taken away when they began.
TEST(FreeFieldSettling, IsFollowedByRestWhereSidesBeginThen) {
  for (const Kinematics kinematics : {Kinematics::finite, Kinematics::small})
    for (unsigned seed = 0; seed < 6; ++seed) {
      Ground ground = level_ground(seed, dry_projected(0.6), 100, kinematics, 1);
      Model& model = ground.model;
      hold_sides_first(1e5 * model.materials[0].young, model);
      model.stages[0].equilibrium = 1e-12;
      model.stages.push_back(stage_of(generalized_alpha_integrator(0.8), 1e-3, 300, kinematics));
      Simulation simulation = simulation_of(model);
      settle(simulation, 1);
      const std::vector<Vec3> before = simulation.state().stress;
      double most = 0;
      for (int i = 0; i < 300; ++i) {
        run(simulation, 1);
        for (std::size_t block = 0; block < before.size(); ++block)
          most = std::max(most, (simulation.state().stress[block] - before[block]).norm());
      }
      EXPECT_LT(most, 1e-9 * ground.weight * rows) << "seed " << seed;
    }
}

}  // namespace
}  // namespace dda
