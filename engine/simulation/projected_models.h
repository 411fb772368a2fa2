// For tests: walls and blocks with dry joints of the projected law.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/simulation/simulation_models.h"

namespace dda {

inline JointMaterial dry_projected(double friction) {
  JointMaterial joint;
  joint.law = InterfaceLaw::projected;
  joint.friction_angle = std::atan(friction);
  return joint;
}

// A wall in running bond on a floor that is shaken by `amplitude` (m), in one stage.
inline Model wall_on_shaken_floor(const Vec2& amplitude, const Stage& stage) {
  Model model = grid_of(4, dry_projected(0.5), Pattern::running_bond);
  model.blocks.push_back(rectangle("floor", -1, -1, 6, 1));
  HeldBlock floor;
  floor.block = static_cast<int>(model.blocks.size()) - 1;
  floor.amplitude = amplitude;
  floor.history = SineCycles{40, 2, 0};
  model.held_blocks = {floor};
  model.gravity = {0, -10};
  model.stages = {stage};
  return model;
}

// One block on a held floor under its weight.
inline Model on_floor(Block block, double friction, const Stage& stage) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction)};
  model.blocks = {rectangle("floor", -2, -1, 6, 1), std::move(block)};
  model.held_blocks.resize(1);
  model.gravity = {0, -10};
  model.stages = {stage};
  return model;
}

// Where all blocks have gone when the run has ended, m.
inline std::vector<Vec2> displacements_of(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  Status status = Status::ok;
  while (status == Status::ok && !simulation.finished()) status = simulation.step();
  EXPECT_EQ(status, Status::ok) << simulation.message();
  std::vector<Vec2> all;
  for (const Vec6& each : simulation.state().displacement) all.emplace_back(each.head<2>());
  return all;
}

// `share`: of the largest of the first ones.
inline void expect_alike(const std::vector<Vec2>& one, const std::vector<Vec2>& other, double share) {
  double largest = 0, off = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    largest = std::max(largest, one[i].norm());
    off = std::max(off, (other[i] - one[i]).norm());
  }
  EXPECT_LE(off, share * largest);
}

}  // namespace dda
