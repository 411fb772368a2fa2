// In-situ stress in blocks between springs: what is in equilibrium stays where it is.
#include <gtest/gtest.h>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// Dry joints are springs whatever the law in finite kinematics.
JointMaterial joint_with(InterfaceLaw law, bool bonded, double friction_angle) {
  JointMaterial joint;
  joint.law = law;
  joint.bonded = bonded;
  joint.friction_angle = friction_angle;
  return joint;
}

// A wall whose outer blocks are held, all blocks under the same stress.
Model stressed_wall(const JointMaterial& joint, const Vec3& stress, Pattern pattern, Kinematics kinematics) {
  constexpr int size = 6;
  Model model = grid_of(size, joint, pattern);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    model.blocks[i].initial_stress = stress;
    Vec2 low = model.blocks[i].shape.outer[0];
    Vec2 high = model.blocks[i].shape.outer[2];
    const bool is_outer = low.x() == 0 || low.y() == 0 || high.x() == size || high.y() > 0.7 * size - 0.1;
    if (is_outer) model.held_blocks.emplace_back().block = static_cast<int>(i);
  }
  model.stages = {stage_of(static_integrator(), 1, 3, kinematics),
                  stage_of(generalized_alpha_integrator(0.8), 1e-3, 100, kinematics)};
  return model;
}

void expect_stays(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  const State start = simulation.state();
  run(simulation, 103);
  for (std::size_t i = 0; i < start.stress.size(); ++i) {
    EXPECT_LT((simulation.state().stress[i] - start.stress[i]).norm(), 1e-9 * start.stress[i].norm()) << i;
    EXPECT_LT(simulation.state().displacement[i].head<2>().norm(), 1e-12) << i;  // of blocks of 1 m
  }
}

const Vec3 oblique(-1e6, -6e5, 1.5e5);  // shear on the joints is a quarter of the pressure at most

TEST(InSituStress, OfDryBlocksStays) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const Pattern pattern : {Pattern::stack, Pattern::running_bond})
      for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent})
        expect_stays(stressed_wall(joint_with(law, false, 0.6), oblique, pattern, kinematics));
}

TEST(InSituStress, OfDryBlocksWithProjectedJointsStays) {
  for (const Pattern pattern : {Pattern::stack, Pattern::running_bond})
    expect_stays(stressed_wall(joint_with(InterfaceLaw::projected, false, 0.6), oblique, pattern, Kinematics::small));
}

TEST(InSituStress, OfBondedBlocksStays) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const Vec3& stress : {oblique, Vec3(-oblique)})  // pulls too
      expect_stays(
          stressed_wall(joint_with(InterfaceLaw::classical, true, 0), stress, Pattern::running_bond, kinematics));
}

// Corners of both blocks, and one within an edge, lie on each other: still each end of a joint is there once.
TEST(InSituStress, OfBlocksWithVerticesOnEachOtherStays) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint_with(InterfaceLaw::classical, false, 0.6)};
  model.blocks = {rectangle("floor", -1, -1, 4, 1), rectangle("left", 0, 0, 1, 1), rectangle("right", 1, 0, 1, 1),
                  rectangle("roof", -1, 1, 4, 1)};
  model.blocks[0].shape.outer = {{-1, -1}, {3, -1}, {3, 0}, {2, 0}, {1, 0}, {0, 0}, {-1, 0}};
  for (Block& block : model.blocks) block.initial_stress = {0, -1e6, 0};
  model.held_blocks.resize(2);
  model.held_blocks[1].block = 3;
  model.stages = {stage_of(static_integrator(), 1, 3, Kinematics::finite),
                  stage_of(generalized_alpha_integrator(0.8), 1e-3, 100, Kinematics::finite)};
  expect_stays(std::move(model));
}

}  // namespace
}  // namespace dda
