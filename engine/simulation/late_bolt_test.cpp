// Bolts that are put in at the start of a later stage, against what can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/simulation/branch.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/snapshot_models.h"
#include "engine/simulation/stopped_run_test_support.h"

namespace dda {
namespace {

constexpr double bolt_stiffness = 3e8;  // N/m

Bolt late_bolt(const Vec2& from, const Vec2& to, double pretension) {
  Bolt bolt;
  bolt.name = "bolt";
  bolt.direction = (to - from).normalized();
  bolt.links = {{0, 1, from, to, bolt_stiffness, 0}};
  bolt.pretension = pretension;
  bolt.first_stage = 1;
  return bolt;
}

// --- A bar pulled at its right end, 1 m high, tied back to a wall by a bolt from the second stage on ---

constexpr double length = 10, reach = 8;  // m, of the bar and from its left end to the bolt's anchor
constexpr double half_load = 2e5;         // N
constexpr double spring = 5e10;           // N/m, of each of the two that hold its left end

Model pulled_bar(double pretension, Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.blocks = {rectangle("wall", -2, 0, 1, 1), rectangle("bar", 0, 0, length, 1)};
  model.held_blocks = {HeldBlock{}};
  model.supports = {{1, {0, 0}, true, false, spring, Vec2::Zero(), {}},
                    {1, {0, 1}, true, false, spring, Vec2::Zero(), {}},
                    {1, {5, 0.5}, false, true, 1e9, Vec2::Zero(), {}}};
  const PiecewiseLinear load{{0, 1, 1.05, 2}, {1, 1, 2, 2}};
  model.edge_loads = {{1, {length, 0}, {length, 1}, {half_load, 0}, load}};
  model.bolts = {late_bolt({-1.5, 0.5}, {reach, 0.5}, pretension)};
  model.stages = {stage_of(static_integrator(), 0.1, 10, kinematics),
                  stage_of(static_integrator(), 0.1, 10, kinematics)};
  return model;
}

// With B the bolt's force the bar's constant strain is (F L - B p)/(E A L) by virtual work, and its anchor moves by
// u = (F - B)/(2 k) + p (F L - B p)/(E A L). The bolt answers what u grows by after the first stage.
double closed_form(double pretension) {
  const double young = rock().young;
  const double per_load = 1 / (2 * spring) + reach / young;
  const double per_force = 1 / (2 * spring) + reach * reach / (young * length);
  return (pretension + bolt_stiffness * half_load * per_load) / (1 + bolt_stiffness * per_force);
}

TEST(LateBolt, CarriesOnlyWhatComesAfterIt) {
  for (const double pretension : {0.0, 5e4}) {
    Simulation simulation = simulation_of(pulled_bar(pretension, Kinematics::small));
    EXPECT_TRUE(simulation.plan().linear) << "nothing can change before there is a bolt";
    run(simulation, 9);
    EXPECT_EQ(simulation.bolts().state(0, 0).force, Vec2(0, 0));
    EXPECT_EQ(simulation.bolts().elongation(0, 0), 0);
    EXPECT_EQ(simulation.energy().bolts, 0);
    run(simulation, 1);
    // Put in: its force is the pretension, whatever the bar's elongation, and who tensioned it has worked.
    EXPECT_FALSE(simulation.plan().linear);
    EXPECT_EQ(simulation.bolts().state(0, 0).force(0), bolt_stiffness * (pretension / bolt_stiffness));
    const double tensioned = pretension * pretension / (2 * bolt_stiffness);
    EXPECT_NEAR(simulation.energy().bolts, tensioned, 1e-12 * tensioned);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
    run(simulation, 10);
    // Static steps leave what inertia holds, and Newton's passes, at the round-off of the springs' stiffness.
    const double force = simulation.bolts().state(0, 0).force(0);
    EXPECT_NEAR(force, closed_form(pretension), 1e-7 * closed_form(pretension));
    EXPECT_NEAR(simulation.energy().bolts, force * force / (2 * bolt_stiffness), 1e-9 * simulation.energy().bolts);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-12);
  }
}

// Strains are 4e-4: so is what growing lengths change.
TEST(LateBolt, CarriesTheSameInFiniteKinematics) {
  for (const double pretension : {0.0, 5e4}) {
    Simulation simulation = simulation_of(pulled_bar(pretension, Kinematics::finite));
    run(simulation, 20);
    const double force = simulation.bolts().state(0, 0).force(0);
    EXPECT_NEAR(force, closed_form(pretension), 1e-3 * closed_form(pretension));
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-10);
  }
}

// A bolt that is there from the start takes its share of the whole load, twice as much.
TEST(LateBolt, CarriesHalfOfWhatAnEarlyOneDoes) {
  Model early = pulled_bar(0, Kinematics::small);
  early.bolts[0].first_stage = 0;
  Simulation simulation = simulation_of(std::move(early));
  run(simulation, 20);
  EXPECT_NEAR(simulation.bolts().state(0, 0).force(0), 2 * closed_form(0), 1e-7 * closed_form(0));
}

// --- Restarts and branches ---

// `model` with a second stage, from step `steps` of a hundred on, at whose start its last bolt is put in.
Model with_late_bolt(Model model, int steps) {
  Stage second = model.stages[0];
  second.name = "bolted";
  second.duration = (100 - steps) * second.dt;
  model.stages[0].duration = steps * second.dt;
  model.stages.push_back(second);
  model.bolts.back().first_stage = 1;
  finish_model(model);
  return model;
}

struct Scene {
  const char* name;
  Model (*model)();
};

std::vector<Scene> scenes() {
  return {{"dry, two bolts, one of them late", [] { return snapshots::bolted_stack(Kinematics::finite); }},
          {"the same in small kinematics", [] { return snapshots::bolted_stack(Kinematics::small); }},
          {"only late ones",
           [] {
             Model model = snapshots::bolted_stack(Kinematics::finite);
             model.bolts.resize(1);
             return model;
           }},
          {"bonded: linear before", [] { return snapshots::bolted_bar(); }}};
}

TEST(LateBolt, RestartsToTheBit) {
  for (const auto& [name, model] : scenes()) {
    for (const int put_in : {30, 50, 70}) {
      Simulation whole(with_late_bolt(model(), put_in));
      run(whole, 50);
      Simulation resumed(with_late_bolt(model(), put_in));
      restore(resumed, whole.state(), save(whole));
      for (int step = 50; step < 100; ++step) {
        ASSERT_EQ(whole.step(), Status::ok) << name;
        ASSERT_EQ(resumed.step(), Status::ok) << name;
        for (std::size_t i = 0; i < whole.state().velocity.size(); ++i) {
          ASSERT_EQ(whole.state().displacement[i], resumed.state().displacement[i]) << name << ", step " << step;
          ASSERT_EQ(whole.state().velocity[i], resumed.state().velocity[i]) << name << ", step " << step;
        }
        ASSERT_EQ(whole.energy().bolts, resumed.energy().bolts) << name << ", step " << step;
        ASSERT_EQ(whole.energy().external_work, resumed.energy().external_work) << name << ", step " << step;
      }
      EXPECT_FALSE(whole.bolts().links().back().state.waits) << name;
    }
  }
}

// The settled run knows nothing of the bolt; its branch puts it in as the whole run does.
TEST(LateBolt, BranchesToTheBit) {
  for (const auto& [name, model] : scenes()) {
    const Model with = with_late_bolt(model(), 40);
    Model without = with;
    without.bolts.pop_back();
    without.stages.resize(1);
    Simulation settled(without);
    run(settled, 40);
    Simulation whole(with);
    run(whole, 40);
    Simulation branch(with);
    begin_from(settled, branch);
    SCOPED_TRACE(name);
    expect_same_course(branch, whole);
  }
}

// What was there, and is put in later by the branch, is taken out until then.
TEST(LateBolt, OfABranchIsWhereItsSceneSays) {
  Model branch_model = with_late_bolt(snapshots::bolted_stack(Kinematics::finite), 40);
  branch_model.stages.push_back(branch_model.stages[1]);
  branch_model.stages[2].name = "last";
  branch_model.bolts.back().first_stage = 2;
  Model settled_model = branch_model;
  settled_model.stages.resize(1);
  for (Bolt& bolt : settled_model.bolts) bolt.first_stage = 0;
  Simulation settled(settled_model);
  run(settled, 40);
  ASSERT_FALSE(settled.bolts().links().back().state.waits);
  Simulation branch(branch_model);
  begin_from(settled, branch);
  EXPECT_TRUE(branch.bolts().links().back().state.waits);
  EXPECT_EQ(branch.bolts().links().front().state.force, settled.bolts().links().front().state.force);
  EXPECT_LT(std::abs(branch.energy().relative_residual()), 1e-11);
  run(branch, 60);
  const Bolt& bolt = branch_model.bolts.back();
  const double stiffness = bolt.links[0].axial_stiffness;
  EXPECT_EQ(branch.bolts().links().back().state.force(0), stiffness * (bolt.pretension / stiffness));
  run(branch, 20);
  EXPECT_LT(std::abs(branch.energy().relative_residual()), 1e-11);
}

// --- Together with an excavation ---

// Three blocks under in-situ stress; the middle one is taken out, and a bolt across the gap comes in the same moment or
// a stage later. Elongation is what the anchors part by from then on.
TEST(LateBolt, TakesWhatFollowsAnExcavation) {
  for (const int first_stage : {1, 2}) {
    Model model;
    model.materials = {rock()};
    model.joints = {strong(InterfaceLaw::consistent)};
    model.blocks = {rectangle("left", 0, 0, 1, 1), rectangle("right", 2, 0, 1, 1), rectangle("tunnel", 1, 0, 1, 1)};
    for (Block& block : model.blocks) block.initial_stress = {-2e6, 0, 0};
    for (const double y : {0.0, 1.0}) {
      model.supports.push_back({0, {0, y}, true, true, 4e9, Vec2::Zero(), {}});
      model.supports.push_back({1, {3, y}, true, true, 4e9, Vec2::Zero(), {}});
    }
    model.edge_loads = {{0, {0, 1}, {0, 0}, {2e6, 0}, Constant{}}, {1, {3, 0}, {3, 1}, {-2e6, 0}, Constant{}}};
    model.bolts = {late_bolt({0.5, 0.5}, {2.5, 0.5}, 1e3)};
    model.bolts[0].first_stage = first_stage;
    model.bolts[0].tension_only = false;
    model.stages.assign(3, stage_of(generalized_alpha_integrator(0.8), 1e-4, 30));
    model.stages[1].removal.blocks = {2};
    Simulation simulation = simulation_of(std::move(model));
    const auto parted = [&] {
      return point_displacement(simulation.model(), simulation.state(), 1, {2.5, 0.5}).x() -
             point_displacement(simulation.model(), simulation.state(), 0, {0.5, 0.5}).x();
    };
    run(simulation, 30 * first_stage);
    const double before = parted();
    EXPECT_EQ(std::abs(before) > 1e-6, first_stage == 2);
    run(simulation, 25);
    // Gaps are sums of the steps' changes: each adds its round-off of displacements of 1e-4 m.
    EXPECT_NEAR(simulation.bolts().elongation(0, 0), parted() - before, 1e-17);
    EXPECT_NEAR(simulation.bolts().state(0, 0).force(0), 1e3 + bolt_stiffness * (parted() - before), 1e-8);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
}

// --- Through air ---

// A stone falls for half a second; then a grouted bolt and a lining come in between it and its neighbour above. One
// that has fallen by less than a tenth of its size has an open joint.
TEST(LateBolt, IsToldOfWhereBlocksHaveParted) {
  for (const double seconds : {0.5, 0.1}) {
    Model model;
    model.materials = {rock()};
    model.joints = {JointMaterial{}};
    model.blocks = {rectangle("roof", 0, 1, 1, 1), rectangle("stone", 0, 0, 1, 1)};
    model.held_blocks = {HeldBlock{}};
    model.gravity = {0, -10};
    Bolt bolt = late_bolt({0.5, 1}, {0.5, 1}, 0);
    bolt.grouted = true;
    bolt.direction = {0, -1};
    model.bolts = {bolt};
    Lining& lining = model.linings.emplace_back();
    lining.nodes = {{0, {1, 1.5}, {0, -1}}, {1, {1, 0.5}, {0, -1}}};
    lining.thickness = 0.1;
    lining.young = 1e9;
    lining.first_stage = 1;
    model.stages.assign(2, stage_of(generalized_alpha_integrator(0), 1e-3, 10, Kinematics::finite));
    model.stages[0].duration = seconds;
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, static_cast<int>(std::lround(seconds / 1e-3)) + 1);
    const std::vector<ReinforcementInAir>& in_air = simulation.results().in_air;
    if (seconds < 0.2) {
      EXPECT_TRUE(in_air.empty());
      continue;
    }
    ASSERT_EQ(in_air.size(), 2U);
    for (const ReinforcementInAir& each : in_air) EXPECT_NEAR(each.way, 10 * seconds * seconds / 2, 1e-3);
    EXPECT_FALSE(in_air[0].is_lining);
    EXPECT_TRUE(in_air[1].is_lining);
  }
}

}  // namespace
}  // namespace dda
