// Rows of bonded blocks one block wide that grow out of a mesh or turn a corner, against beams.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double force = 1e3;

double shear_modulus() { return rock().young / (2 * (1 + rock().poisson)); }

Model bonded_model() {
  Model model;
  model.materials = {rock()};
  model.joints = {bond(InterfaceLaw::consistent)};
  return model;
}

// How far the middle of the last block goes along the force on the face from `from` to `to`.
double motion_along(Model model, const Vec2& from, const Vec2& to, const Vec2& direction) {
  const int last = static_cast<int>(model.blocks.size()) - 1;
  model.edge_loads = {{last, from, to, force * direction, Constant{}}};
  Stage stage = stage_of(static_integrator(), 1e3, 200);
  stage.equilibrium = 1e-8;
  model.stages = {stage};
  Simulation simulation = simulation_of(model);
  while (!simulation.finished())
    if (simulation.step() != Status::ok) throw std::runtime_error(simulation.message());
  const Vec2 middle = simulation.model().blocks[static_cast<std::size_t>(last)].moments.centroid;
  return point_displacement(simulation.model(), simulation.state(), last, middle).dot(direction);
}

// ---- An arm of squares of 1 m out of a mesh of larger squares, which is held at its other side.

double bottom_of_arm(int size, int across) { return size * (across / 2) + size / 2; }  // on the block in the middle

Model arm_out_of_mesh(int blocks, int size, int across) {
  Model model = bonded_model();
  const double side = size * across;
  const double bottom = bottom_of_arm(size, across);
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) model.blocks.push_back(rectangle("", size * i, size * j, size, size));
  model.blocks.push_back(rectangle("wall", -1, 0, 1, side));
  model.held_blocks.emplace_back().block = across * across;
  for (int i = 0; i < blocks; ++i) model.blocks.push_back(rectangle("", side + i, bottom, 1, 1));
  return model;
}

// By how much the root turns, over what it turns by at the edge of a half plane: 16.67 M/(pi E h^2) (O'Donnell, W. J.
// (1960), The additional deflection of a cantilever due to the elasticity of the support, Journal of Applied Mechanics
// 27, 461-464). The rest is Timoshenko's beam, with the shear stress uniform across as blocks of one strain have it.
double relative_turn_of_root(int blocks, int size, int across) {
  const double side = size * across;
  const double bottom = bottom_of_arm(size, across);
  const double right = side + blocks;
  const double sinks =
      motion_along(arm_out_of_mesh(blocks, size, across), {right, bottom}, {right, bottom + 1}, -Vec2::UnitY());
  const double to_middle = blocks - 0.5;  // of the last block, where it is measured
  const double bends = 12 * (blocks * to_middle * to_middle / 2 - std::pow(to_middle, 3) / 6) / rock().young;
  const double shears = to_middle / shear_modulus();
  const double turn = 16.67 / std::numbers::pi * blocks / rock().young;
  return (sinks / force - bends - shears) / (turn * to_middle);
}

// A fifth is left to the mesh, in which blocks that turn against each other stand for a part of what strains around the
// root: for two fifths where they are as wide as the row. With the stiffness of a mesh in that joint the root
// turned 6.0 to 6.5 times as far as that of a half plane.
TEST(RowOutOfAMesh, TurnsAtItsRootAsAtAHalfPlane) {
  for (const int blocks : {8, 16}) {
    EXPECT_NEAR(relative_turn_of_root(blocks, 1, 9), 1, 0.2) << blocks;
    EXPECT_NEAR(relative_turn_of_root(blocks, 2, 5), 1, 0.2) << blocks;
    EXPECT_NEAR(relative_turn_of_root(blocks, 3, 5), 1, 0.2) << blocks;
  }
}

// ---- A row that turns a corner: `legs` squares of 1 m along x and as many upwards, the corner in both.

double sway_of_corner(int legs) {
  Model model = bonded_model();
  for (int i = 0; i < legs; ++i) model.blocks.push_back(rectangle("", i, 0, 1, 1));
  model.blocks.push_back(rectangle("wall", -1, 0, 1, 1));
  model.held_blocks.emplace_back().block = legs;
  for (int j = 1; j < legs; ++j) model.blocks.push_back(rectangle("", legs - 1, j, 1, 1));
  return motion_along(model, {legs - 1, legs}, {legs, legs}, Vec2::UnitX());
}

// Beams along the middles of the blocks, joined stiffly in that of the corner.
double sway_of_beams(int legs) {
  const double leg = legs - 0.5;
  const double measured = legs - 1;  // upwards from the corner
  const double upright = 12 * (leg * measured * measured / 2 - std::pow(measured, 3) / 6) / rock().young;
  const double level = 12 * leg * leg * measured / rock().young;  // the moment is the same all along
  return force * (upright + level + measured / shear_modulus() + leg / rock().young);
}

// A corner is stiffer than its centre lines, by the half blocks that bend little in it: fine meshes of 8 x 8 squares in
// each block are 4.3, 2.4 and 1.4 % stiffer with legs of 6, 10 and 16 blocks.
TEST(RowAroundACorner, SwaysAsBeams) {
  for (const int legs : {6, 10, 16})
    EXPECT_NEAR(sway_of_corner(legs) / sway_of_beams(legs), 1 - 0.25 / legs, 0.1 / legs) << legs;
}

}  // namespace
}  // namespace dda
