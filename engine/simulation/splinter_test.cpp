// Splinters that tumble among blocks a thousand times their size: rock is not stepped more often for what weighs
// nothing, and a small stone that is what a scene is about is.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "engine/simulation/settling_drag.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr int steps = 20;

// Stones of 1 m in a row on a base that is held, and one of side `small` that falls beside them and turns by 0.1 rad a
// step.
Model stones_beside(int stones, double small) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  model.blocks = {rectangle("base", -1, -1, stones + 4, 1)};
  for (int i = 0; i < stones; ++i) model.blocks.push_back(rectangle("stone " + std::to_string(i), 1.01 * i, 0, 1, 1));
  model.blocks.push_back(rectangle("small", stones + 1, 2, small, small));
  const Stage stage = stage_of(generalized_alpha_integrator(0), 1e-4, steps, Kinematics::finite);
  model.blocks.back().initial_spin = 0.1 / stage.dt;
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  model.stages = {stage};
  return model;
}

std::int64_t parts_taken(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.counters().steps;
}

TEST(Splinter, TurnsWithoutCuttingTheStepsOfAllOthers) { EXPECT_EQ(parts_taken(stones_beside(3, 5e-4)), steps); }

// What would be cut for ever is stepped in the shortest parts: a turn of 50 rad a step in 64 of them by 0.8.
TEST(Splinter, EndsNoRunThatItTumblesThroughUnresolved) {
  Model model = stones_beside(3, 5e-4);
  model.blocks.back().initial_spin *= 500;
  EXPECT_EQ(parts_taken(std::move(model)), 64 * steps);
}

// A turn of 0.1 is cut into sixteenths, the first power of two below 0.01.
TEST(Splinter, IsNoStoneThatIsAThousandthOfTheArea) { EXPECT_EQ(parts_taken(stones_beside(3, 0.03)), 16 * steps); }

TEST(Splinter, IsNoStoneBesideOneLargeBlockAlone) { EXPECT_EQ(parts_taken(stones_beside(1, 5e-4)), 16 * steps); }

// What a static stage takes to be loose: what goes far under drag, and not what others carry.

// A block of 1 m.
BlockTerms one_block() {
  BlockTerms terms;
  terms.area = {1.0};
  return terms;
}

Eigen::VectorXd moved_by(double way) {
  Eigen::VectorXd d = Eigen::VectorXd::Zero(6);
  d(1) = way;
  return d;
}

// Whether the block is loose after a hundred steps, in each of which it would go by `first` (m), and with more drag by
// `second`.
bool is_loose(double first, double second) {
  const BlockTerms terms = one_block();
  SettlingDrag drag;
  for (int step = 0; step < 100; ++step) {
    drag.ease();
    EXPECT_TRUE(drag.raise(terms, {}, moved_by(first)));
    drag.raise(terms, {}, moved_by(second));
    drag.follow(terms, moved_by(second));
  }
  return !drag.loose().empty();
}

TEST(SettlingDrag, WhatItHoldsBackIsLooseOnceItHasGoneHalfOfItsSize) { EXPECT_TRUE(is_loose(2, 0.015)); }

// Ten blocks of 1 m, and a small one that goes by what it is allowed to until it is loose: in three steps of a fifth of
// its size at most, where others take 25 of a fiftieth.
int steps_until_loose(double area) {
  BlockTerms terms;
  terms.area.assign(11, 1.0);
  terms.area[10] = area;
  SettlingDrag drag;
  for (int step = 1; step <= 100; ++step) {
    drag.ease();
    double share = 2;  // of its size, without more drag
    const auto d = [&] {
      Eigen::VectorXd moved = Eigen::VectorXd::Zero(66);
      moved(61) = share * std::sqrt(area);
      return moved;
    };
    EXPECT_TRUE(drag.raise(terms, {}, d()));
    share = area < 0.01 ? 0.19 : 0.019;
    EXPECT_FALSE(drag.raise(terms, {}, d())) << "no farther than it may";
    drag.follow(terms, d());
    if (!drag.loose().empty()) return step;
  }
  return 0;
}

TEST(SettlingDrag, LetsSmallBlocksGoByMoreOfTheirSize) {
  EXPECT_EQ(steps_until_loose(0.009), 3);
  EXPECT_EQ(steps_until_loose(0.011), 27);
}

// A splinter between blocks that sink goes with them, by many times its size a step.
TEST(SettlingDrag, WhatOthersCarryIsNotLoose) { EXPECT_FALSE(is_loose(2, 1.9)); }

}  // namespace
}  // namespace dda
