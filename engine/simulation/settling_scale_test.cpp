// Static stages in which what acts is no load: what is out of balance is judged against the forces that it causes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/block_system.h"
#include "engine/simulation/settling_cushion.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// Sizes are powers of two, and so are stiffnesses: the forces of all scenes are then the same numbers in other units.
struct Scale {
  double length;   // m
  double modulus;  // Pa
};
const std::vector<Scale> scales = {{1.0 / 1024, 1024}, {1, 1 << 30}, {1024, std::ldexp(1, 37)}};

// Static stages that pace themselves, or, with `steps`, of steps as long as a P wave takes through some blocks.
Stage settling(const Scale& scale, const Material& material, int steps) {
  const double transit = scale.length * std::sqrt(material.density / material.young);
  Stage stage = stage_of(static_integrator(), steps == 0 ? 0 : 32 * transit, steps, Kinematics::small);
  stage.equilibrium = 1e-9;
  return stage;
}

// Four by four blocks between a floor and a lid.
Model press(const Scale& scale, const JointMaterial& joint, int steps) {
  Model model;
  model.materials = {{"stone", 2048, scale.modulus, 0.2, PlaneState::stress}};
  model.joints = {joint};
  const double l = scale.length;
  for (int i = 0; i < 16; ++i)
    model.blocks.push_back(rectangle("b" + std::to_string(i), l * (i % 4), l * (i / 4), l, l));
  model.blocks.push_back(rectangle("floor", -l, -l, 6 * l, l));
  model.blocks.push_back(rectangle("lid", -l, 4 * l, 6 * l, l));
  model.held_blocks.resize(2);
  model.held_blocks[0].block = 16;
  model.held_blocks[1].block = 17;
  model.stages = {settling(scale, model.materials[0], steps)};
  return model;
}

Model pressed_by_its_lid(const Scale& scale, const JointMaterial& joint, int steps) {
  Model model = press(scale, joint, steps);
  model.held_blocks[1].amplitude = {0, -scale.length / 8192};
  return model;
}

// The lid is not held, and springs bring its middle down.
Model pressed_by_a_support(const Scale& scale, const JointMaterial& joint, int steps) {
  Model model = press(scale, joint, steps);
  model.held_blocks.pop_back();
  PointSupport support;
  support.block = 17;
  support.point = {2 * scale.length, 5 * scale.length};
  support.stiffness = 8 * scale.modulus;
  support.amplitude = {0, -scale.length / 8192};
  model.supports = {support};
  return model;
}

// The lid is free, and a bolt draws it to the floor.
Model tensioned(const Scale& scale, const JointMaterial& joint, int steps) {
  Model model = press(scale, joint, steps);
  model.held_blocks.pop_back();
  Bolt bolt;
  bolt.name = "bolt";
  bolt.direction = Vec2::UnitY();
  bolt.links = {{16, 17, {2 * scale.length, 0}, {2 * scale.length, 5 * scale.length}, scale.modulus / 16, 0}};
  bolt.pretension = scale.modulus * scale.length / 8192;
  model.bolts = {bolt};
  return model;
}

// Nothing stands against the motion of the lid, so that in the end there is no force anywhere.
Model carried_along(const Scale& scale, const JointMaterial& joint, int steps) {
  Model model = pressed_by_its_lid(scale, joint, steps);
  model.held_blocks.erase(model.held_blocks.begin());
  return model;
}

using MakeModel = Model (*)(const Scale&, const JointMaterial&, int);
const std::vector<MakeModel> all_models = {pressed_by_its_lid, pressed_by_a_support, tensioned, carried_along};

Simulation ended(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished())
    if (simulation.step() != Status::ok) break;
  return simulation;
}

double held_force(const Simulation& simulation, int block) {
  return simulation.system().forces.internal_old(6 * block + 1);
}

// What is left of equilibrium in so many steps is far above round-off, and the same share on every scale.
TEST(SettlingScale, ShareOutOfBalanceHasNoSizeOfItsOwn) {
  for (std::size_t i = 0; i < all_models.size(); ++i) {
    std::vector<double> shares;
    for (const Scale& scale : scales)
      shares.push_back(ended(all_models[i](scale, bond(InterfaceLaw::classical), 2)).results().out_of_balance[0]);
    EXPECT_GT(shares[0], 1e-9) << i;
    EXPECT_LT(shares[0], 1) << i;
    // Round-off of a solve, in forces that are this share of the largest.
    for (const double share : shares) EXPECT_NEAR(share, shares[0], 1e-9) << i;
  }
}

TEST(SettlingScale, StagesFindTheirEquilibriumOnEveryScale) {
  for (const JointMaterial& joint : {bond(InterfaceLaw::classical), strong(InterfaceLaw::classical)})
    for (std::size_t i = 0; i < all_models.size(); ++i)
      for (const Scale& scale : scales) {
        const Simulation simulation = ended(all_models[i](scale, joint, 0));
        EXPECT_EQ(simulation.message(), "") << i << ", " << scale.length << " m";
        EXPECT_LE(simulation.results().out_of_balance[0], 1e-9) << i;
        EXPECT_LE(simulation.state().step, 40) << i << ", " << scale.length << " m";
      }
}

// What a lid gives the floor takes: the two differ by what is out of balance in 16 blocks at most.
TEST(SettlingScale, ReactionsThatMustCancelDoSoToTheShareAskedFor) {
  for (const Scale& scale : scales)
    for (const double share : {1e-2, 1e-4, 1e-6}) {
      Model model = pressed_by_its_lid(scale, bond(InterfaceLaw::classical), 1000);
      model.stages[0].equilibrium = share;
      const Simulation simulation = ended(std::move(model));
      EXPECT_LT(simulation.state().step, 1000);
      const double floor = held_force(simulation, 16);
      const double lid = held_force(simulation, 17);
      EXPECT_NEAR(floor / lid, -1, 16 * share) << scale.length << " m";
    }
}

// A run from a snapshot knows the forces of before.
TEST(SettlingScale, GoesOnFromASnapshotWithTheSameShare) {
  const auto make = [] { return simulation_of(carried_along(scales[1], bond(InterfaceLaw::classical), 4)); };
  Simulation whole = make();
  run(whole, 2);
  Simulation restored = make();
  restored.restore(whole.state(), whole.save());
  EXPECT_GT(whole.out_of_balance(), 0);
  EXPECT_EQ(restored.out_of_balance(), whole.out_of_balance());
}

// A bolt without pretension, a support that stays and a floor that stays do not act: with weight, what counts is it.
TEST(SettlingScale, WhatOnlyHoldsDoesNotCount) {
  Model model = pressed_by_its_lid(scales[1], bond(InterfaceLaw::classical), 2);
  model.held_blocks.pop_back();
  model.gravity = {0, -10};
  const Simulation simulation = ended(std::move(model));
  const BlockSystem& system = simulation.system();
  Eigen::VectorXd unbalanced = system.unbalanced_forces();
  system.held.clear(unbalanced);
  double largest = 0;
  for (Eigen::Index block = 0; block < 18; ++block)
    largest = std::max({largest, unbalanced.segment<2>(6 * block).cwiseAbs().maxCoeff(),
                        unbalanced.segment<4>(6 * block + 2).cwiseAbs().maxCoeff() /
                            std::sqrt(system.terms.area[static_cast<std::size_t>(block)])});
  EXPECT_DOUBLE_EQ(simulation.results().out_of_balance[0], largest / (6 * 2048 * 10));  // the lid's weight
}

// When a stage lets go of what helped it on, and when its steps grow.

Model finished_press() {
  Model model = press(scales[1], JointMaterial{}, 0);
  finish_model(model);
  return model;
}

TEST(SettlingCushion, LetsGoWithAStepThatHasNextToNothingToChange) {
  const BlockSystem system(finished_press());
  SettlingCushion cushion;
  EXPECT_FALSE(cushion.wears(1)) << "there is none";
  ASSERT_TRUE(cushion.put_in(system));
  EXPECT_TRUE(cushion.wears(6));
  EXPECT_TRUE(cushion.is_in());
  EXPECT_TRUE(cushion.wears(5));
  EXPECT_FALSE(cushion.is_in());
  EXPECT_FALSE(cushion.put_in(system)) << "once a stage";
}

// A pace that has tried its long step in vain, and taken a short one in so many passes that the next is as long.
SettlingPace after_the_try() {
  const Model model = finished_press();
  SettlingPace pace;
  pace.begin(model, model.stages[0], true, false);
  Counters counters;
  const auto fails_if_long = [&](double, Taken taken) {
    counters.open_close_iterations += 40;
    return taken == Taken::if_hardly_slips ? Status::not_converged : Status::ok;
  };
  EXPECT_EQ(pace.step(counters, fails_if_long, [] { return false; }), Status::ok);
  return pace;
}

// One long step comes first, and only if next to nothing slips in it; then a short one.
TEST(SettlingPace, TriesALongStepFirst) {
  const Model model = finished_press();
  SettlingPace pace;
  pace.begin(model, model.stages[0], true, false);
  std::vector<std::pair<double, Taken>> asked;
  const auto fails_if_long = [&](double dt, Taken taken) {
    asked.emplace_back(dt, taken);
    return taken == Taken::if_hardly_slips ? Status::not_finite : Status::ok;
  };
  EXPECT_EQ(pace.step({}, fails_if_long, [] { return false; }), Status::ok);
  ASSERT_EQ(asked.size(), 2U);
  EXPECT_EQ(asked[0].second, Taken::if_hardly_slips);
  EXPECT_EQ(asked[1].second, Taken::unless_cut);
  EXPECT_NEAR(asked[0].first / asked[1].first, 100, 1e-9);
  pace.begin(model, model.stages[0], true, true);
  EXPECT_EQ(pace.taken(), Taken::unless_cut) << "loads in parts wait for long steps";
  pace.begin(model, model.stages[0], false, false);
  EXPECT_EQ(pace.taken(), Taken::to_the_end) << "nothing can slip";
}

// Steps grow to a hundred transit times, or to what weight takes to move rock where that is longer.
TEST(SettlingPace, StepsAreLongBesideWhatWeightMoves) {
  const auto longest = [](double gravity) {
    Model model = finished_press();
    model.gravity = {0, -gravity};
    SettlingPace pace;
    pace.begin(model, model.stages[0], true, true);
    const double transit = pace.dt();
    EXPECT_FALSE(pace.is_long());
    for (int i = 0; i < 60; ++i) pace.settled(1, false);
    EXPECT_TRUE(pace.is_long());
    return pace.dt() / transit;
  };
  EXPECT_NEAR(longest(0), 100, 1e-9);
  EXPECT_NEAR(longest(1e-20) / longest(1e-22), 0.1, 1e-9);
}

// With friction given by its start a step of any length settles, and takes as many passes when it is longer.
TEST(SettlingPace, StepsThatAreSureToSettleGrowAfterManyPasses) {
  const auto growth = [](std::int64_t passes, bool is_sure) {
    SettlingPace pace = after_the_try();
    const double before = pace.dt();
    pace.settled(passes, is_sure);
    return pace.dt() / before;
  };
  EXPECT_EQ(growth(30, false), 8);
  EXPECT_EQ(growth(31, false), 1);
  EXPECT_EQ(growth(61, false), 0.25);
  EXPECT_EQ(growth(100, true), 8);
  EXPECT_EQ(growth(101, true), 1);
}

}  // namespace
}  // namespace dda
