// Walls on a base that is turned and moved in a static stage lean and strain as if gravity were turned on a base that
// stays, and nothing slips.
#include "engine/simulation/carried_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;  // m/s2
constexpr double friction_of_bricks = 0.7;

struct BaseMotion {
  double turn = 0;  // rad
  Vec2 about = Vec2::Zero();
  Vec2 way = Vec2::Zero();  // m

  [[nodiscard]] Vec2 seen_from_base(const Vec2& point) const { return rotation(-turn) * (point - about - way) + about; }
};

// Courses of bricks of lengths by lot, on a held block that lies between x = -1 and 1 beyond the wall.
Model random_wall(const JointMaterial& joint, SeededNumbers& random) {
  const int courses = random.integer(1, 6);
  const double length = random.number(1.5, 3), height = random.number(0.2, 0.4);
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  model.blocks = {rectangle("", -1, -1, length + 2, 1)};
  for (int course = 0; course < courses; ++course)
    for (double left = 0; left < length;) {
      double right = left + random.number(0.3, 0.7);
      if (length - right < 0.3) right = length;
      model.blocks.push_back(rectangle("", left, course * height, right - left, height));
      left = right;
    }
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -standard_gravity};
  model.stages = {settling_stage(1e-8)};
  return model;
}

Model moved(Model model, const BaseMotion& motion) {
  HeldBlock& base = model.held_blocks[0];
  base.turn = motion.turn;
  base.about = motion.about;
  base.amplitude = motion.way;
  base.history = PiecewiseLinear{{0, 1}, {0, 1}};
  Stage moving = model.stages[0];
  moving.duration = 1;
  model.stages[0].name = "weight";
  model.stages.push_back(moving);
  return model;
}

Model leaning(Model model, double turn) {
  model.gravity = rotation(-turn) * model.gravity;
  return model;
}

// Where the centroids are at the end.
std::vector<Vec2> ends(Simulation& simulation) {
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    places.push_back(simulation.model().blocks[i].moments.centroid + simulation.state().displacement[i].head<2>());
  return places;
}

struct Lottery {
  const char* name;
  JointMaterial joint;
};

class CarriedWalls : public testing::TestWithParam<Lottery> {};

// Measured: up to 6e-6 m where a brick at an end slides a little on the way, else 1e-6; 400 more by other seeds
// likewise. Before, walls on bases that were turned by some degrees crept by centimetres, and many slid off.
TEST_P(CarriedWalls, LeanAsUnderGravityThatLeans) {
  std::int64_t passes = 0, steps = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    SeededNumbers random(seed);
    const Model wall = random_wall(GetParam().joint, random);
    const BaseMotion motion{random.number(-0.2, 0.2), 10 * random.direction(),
                            random.number(0, 0.5) * random.direction()};
    Simulation tilting = simulation_of(moved(wall, motion));
    Simulation leant = simulation_of(leaning(wall, motion.turn));
    const std::vector<Vec2> there = ends(tilting), here = ends(leant);
    for (std::size_t i = 1; i < there.size(); ++i)
      EXPECT_LT((motion.seen_from_base(there[i]) - here[i]).norm(), 1e-5) << i;
    EXPECT_LT(tilting.energy().friction, 1e-3 * std::abs(tilting.energy().gravity_work));
    for (const Vec6& velocity : tilting.state().velocity) EXPECT_TRUE(velocity.isZero(0));
    passes += tilting.counters().open_close_iterations;
    steps += tilting.counters().steps;
  }
  // Passes begin where blocks are carried to: from rest these took 7 to 30 a step.
  EXPECT_LT(passes, 3 * steps);
}

JointMaterial dry_springs() {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_spring = 10 * rock().young;
  joint.friction_angle = std::atan(friction_of_bricks);
  return joint;
}

INSTANTIATE_TEST_SUITE_P(Laws, CarriedWalls,
                         testing::Values(Lottery{"consistent", dry_projected(friction_of_bricks)},
                                         Lottery{"springs", dry_springs()}),
                         [](const auto& given) { return given.param.name; });

// Three towers of two blocks on bases of their own: one stays, one is turned and one goes away.
TEST(CarriedTowers, GoWithTheirOwnBases) {
  const std::vector<BaseMotion> motions{{}, {.turn = 0.1, .about = {6, -3}}, {.way = {0.3, -40}}};
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction_of_bricks)};
  model.gravity = {0, -standard_gravity};
  model.stages = {settling_stage(1e-8, 1)};
  for (const BaseMotion& motion : motions) {
    const double left = 2.0 * static_cast<double>(model.blocks.size());
    HeldBlock& held = model.held_blocks.emplace_back();
    held.block = static_cast<int>(model.blocks.size());
    held.turn = motion.turn;
    held.about = motion.about;
    held.amplitude = motion.way;
    held.history = PiecewiseLinear{{0, 1}, {0, 1}};
    model.blocks.push_back(rectangle("", left, -1, 3, 1));
    for (const double bottom : {0.0, 0.8}) model.blocks.push_back(rectangle("", left + 1, bottom, 1, 0.8));
  }
  Simulation simulation = simulation_of(std::move(model));
  const std::vector<Vec2> there = ends(simulation);
  const auto way_on_base = [&](std::size_t i) -> Vec2 {
    return motions[i / 3].seen_from_base(there[i]) - simulation.model().blocks[i].moments.centroid;
  };
  for (std::size_t i = 0; i < there.size(); ++i) EXPECT_LT(way_on_base(i).norm(), 1e-4) << i;  // their strains: 4e-5 m
  for (const std::size_t i : {1U, 2U}) EXPECT_LT((way_on_base(i) - way_on_base(i + 6)).norm(), 1e-9) << i;
  EXPECT_EQ(simulation.energy().friction, 0);
}

// One block across two bases of which one sinks belongs to neither.
TEST(CarriedTowers, WhatLiesOnTwoBasesIsCarriedByNone) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction_of_bricks)};
  model.gravity = {0, -standard_gravity};
  model.blocks = {rectangle("", -2, -1, 2, 1), rectangle("", 0, -1, 2, 1), rectangle("", -1.4, 0, 2, 0.5)};
  model.held_blocks.resize(2);
  model.held_blocks[1].block = 1;
  model.held_blocks[1].amplitude = {0, -0.05};
  model.held_blocks[1].history = PiecewiseLinear{{0, 1}, {0, 1}};
  model.stages = {settling_stage(1e-8, 1)};
  Simulation simulation = simulation_of(std::move(model));
  ends(simulation);
  // Its centroid is over the base that stays; its strains make 6e-6 m.
  EXPECT_LT(simulation.state().displacement[2].head<2>().norm(), 2e-5);
}

}  // namespace
}  // namespace dda
