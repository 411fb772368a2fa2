// Dry joints of the consistent law, closed by a stress that is there from the start, in rock cut askew: it moves the
// same whatever corner its outlines begin with, however its blocks are numbered, and turned or mirrored.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "engine/simulation/seen_rock.h"

namespace dda {
namespace {

constexpr int rocks = 30;
constexpr double same = 1e-9;  // share of the motion: sums in another order, and Cholesky factors

// Quadrilaterals whose inner corners are off those of a grid of 1 m by lot, between held blocks.
Model askew_rock(std::uint64_t seed) {
  SeededNumbers random(seed);
  constexpr int size = 3;
  Vec2 nodes[size + 1][size + 1];
  for (int i = 0; i <= size; ++i)
    for (int j = 0; j <= size; ++j) {
      const bool inner = i > 0 && j > 0 && i < size && j < size;
      nodes[i][j] = {i + (inner ? random.number(-0.2, 0.2) : 0), j + (inner ? random.number(-0.2, 0.2) : 0)};
    }
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.25, PlaneState::strain}};
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  joint.friction_angle = 0.9;
  model.joints = {joint};
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      const Ring ring = {nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1]};
      model.blocks.push_back(block_of("block " + std::to_string(model.blocks.size()), ring));
    }
  add_held("floor", 0, -1, size, 0, model);
  add_held("left", -1, 0, 0, size, model);
  add_held("right", size, 0, size + 1, size, model);
  add_held("roof", 0, size, size, size + 1, model);
  for (Block& block : model.blocks) block.initial_stress = {-5e6, -5e6, 0};
  model.blocks[static_cast<std::size_t>(random.integer(0, 5))].initial_velocity = {0.01, -0.02};
  return model;
}

std::vector<Vec3> motion(const Model& drawn, const View& view) {
  Model model = seen(drawn, view);
  Simulation simulation = simulation_of(model);
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_EQ(simulation.counters().contact_state_changes, 0) << "joints stay closed and stuck";
  return motion_of(simulation, view);
}

std::vector<int> reversed_order(std::size_t blocks) {
  std::vector<int> order(blocks);
  std::iota(order.rbegin(), order.rend(), 0);
  return order;
}

TEST(PressedJoints, MoveTheSameHoweverTheyAreSeen) {
  for (std::uint64_t seed = 1; seed <= rocks; ++seed) {
    Model rock = askew_rock(seed);
    rock.stages = {stage_of(trapezoidal_integrator(), 2e-5, 60)};
    const std::vector<Vec3> expected = motion(rock, {});
    std::vector<View> views = {{.name = "rings from the second corner", .first_corner = 1},
                               {.name = "rings from the third corner", .first_corner = 2},
                               {.name = "reversed", .order = reversed_order(rock.blocks.size())},
                               {.name = "turned", .turn = rotation(SeededNumbers(seed).number(0, 6))},
                               {.name = "mirrored", .turn = Mat2{{-1, 0}, {0, 1}}}};
    for (const View& view : views)
      EXPECT_LE(difference(expected, motion(rock, view)), same) << view.name << ", seed " << seed;
  }
}

}  // namespace
}  // namespace dda
