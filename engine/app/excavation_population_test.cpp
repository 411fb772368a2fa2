// Rock cut at random, stressed, with an opening that is removed in a run: a hundred seeds, bonded and dry, as drawn and
// moving. The oracle shares nothing with removing: the same rock whose opening was never there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/random_rock_test_support.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/model/energy_release.h"
#include "engine/scene/scene.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 26;  // of each kind of joint
constexpr int moving = 40;

enum class Removed { never, at_once, kept, slowly };

const RockKind kinds[] = {
    {"bonded", {{"bonded", true}}, "small"},
    {"dry", {{"friction_angle", "40 deg"}}, "finite"},
    // Springs that are chosen look at dt and pressure, which differ between scenes with and without an opening.
    {"strong",
     {{"friction_angle", "35 deg"}, {"cohesion", "1 MPa"}, {"tensile_strength", "0.3 MPa"}, {"spring_over_young", 10}},
     "finite"},
    {"dry as drawn", {{"friction_angle", "40 deg"}}, "small"}};

Model model_of(int seed, const RockKind& kind, Removed removed) {
  json settle = {
      {"name", "settle"}, {"integrator", "static"}, {"dt", 1}, {"duration", 1}, {"kinematics", kind.kinematics}};
  const json motion = motion_of(kind, "motion", moving);
  json steps = {settle, motion};
  if (removed == Removed::never) steps = {motion};
  if (removed == Removed::at_once) steps[1]["remove"] = json::array({"opening"});
  if (removed == Removed::kept)
    steps[1]["remove"] = {{"blocks", json::array({"opening"})}, {"table", {{0, 1}, {1, 1}}}};
  if (removed == Removed::slowly) steps[1]["remove"] = {{"blocks", json::array({"opening"})}, {"over", "2 ms"}};
  const json scene = scene_with_opening(seed, kind, removed == Removed::never, steps);
  return parse_scene(scene.dump(), fmt::format("seed {}", seed));
}

void run_to_end(Simulation& simulation) {
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

// To the last bit. `resumed` goes on from a snapshot of a run like `whole`.
void expect_same_end(Simulation& resumed, Simulation& whole) {
  run_to_end(whole);
  run_to_end(resumed);
  EXPECT_EQ(std::memcmp(&resumed.energy(), &whole.energy(), sizeof(EnergyLedger)), 0);
  for (std::size_t i = 0; i < whole.model().blocks.size(); ++i)
    EXPECT_EQ(resumed.state().displacement[i], whole.state().displacement[i]);
}

bool is_present(const Simulation& simulation, std::size_t block) {
  return simulation.absent().empty() || !simulation.absent()[block];
}

double largest_motion(const Simulation& simulation) {
  double most = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    if (is_present(simulation, i)) most = std::max(most, simulation.state().displacement[i].head<2>().norm());
  return most;
}

// Largest difference of the motions of blocks of one place.
double largest_difference(const Simulation& removed, const Simulation& never) {
  double most = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < removed.model().blocks.size(); ++i) {
    if (!is_present(removed, i)) continue;
    for (std::size_t j = 0; j < never.model().blocks.size(); ++j) {
      const AreaMoments& one = removed.model().blocks[i].moments;
      const AreaMoments& other = never.model().blocks[j].moments;
      if ((one.centroid - other.centroid).norm() > 1e-9 || std::abs(one.area - other.area) > 1e-9) continue;
      most = std::max(most, (removed.state().displacement[i] - never.state().displacement[j]).head<2>().norm());
      ++found;
    }
  }
  EXPECT_EQ(found, never.model().blocks.size());
  return most;
}

// Nobody touches the rock: its surroundings push on the outside with the stress there is, absorbing or not.
Model left_alone(int seed, const RockKind& kind, const json& blocks, const json& field, bool absorbing) {
  json scene = {{"dda", 1},
                {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
                {"joints", {{"default", kind.joint}}},
                {"blocks", blocks},
                {"stress_field", field},
                {"steps", motion_of(kind, "motion", moving)}};
  if (field.contains("surface")) scene["gravity"] = 10;
  if (absorbing) {
    scene["viscous_boundaries"] = {{{"edge", "outside"}, {"carries_initial_stress", true}}};
  } else {
    scene["loads"] = {{{"edge", "outside"}, {"traction", "in-situ"}}};
  }
  return parse_scene(scene.dump(), fmt::format("left alone {}", seed));
}

// Where faces are much shorter than their blocks, vertices on edges of blocks that move can be too near to each other
// to be two contacts; rock that leans on such a face does not start in balance.
bool starts_in_balance(int seed, const RockKind& kind) {
  return Simulation(left_alone(seed, kind, {{"rock", rock_with_opening(seed, false)}}, uniform_field, false))
             .out_of_balance() < 1e-9;
}

// Salamon's two forms agree over the run and in every stage, and those of the stages add up.
void expect_both_forms_of_release(const Simulation& simulation) {
  const EnergyRelease whole = energy_release(simulation.energy());
  EXPECT_LT(std::abs(whole.relative_difference()), 1e-9);
  EXPECT_GT(whole.removed, 0);
  double by_work = 0;
  double by_fate = 0;
  const EnergyLedger* before = nullptr;
  const double scale = simulation.energy().scale();
  for (const EnergyLedger& end : energy_at_ends_of_stages(simulation)) {
    const EnergyRelease stage = before == nullptr ? energy_release(end) : energy_release(*before, end);
    EXPECT_LT(std::abs(stage.by_work() - stage.by_fate()), 1e-9 * scale);
    by_work += stage.by_work();
    by_fate += stage.by_fate();
    before = &end;
  }
  if (!simulation.finished()) return;
  EXPECT_NEAR(by_work, whole.by_work(), 1e-12 * scale);
  EXPECT_NEAR(by_fate, whole.by_fate(), 1e-12 * scale);
}

class ExcavatedRock : public testing::TestWithParam<RockKind> {
 protected:
  template <typename Body>
  static void with_each_rock(Body body) {
    int unbalanced = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(seed);
      if (starts_in_balance(seed, GetParam())) {
        body(seed, GetParam());
      } else {
        ++unbalanced;
      }
    }
    EXPECT_LE(unbalanced, std::string(GetParam().name) == "dry" ? 2 : 0);
  }
};

// How much motions may differ, as a share of the largest. The balance holds to 1e-10 of the largest contact force, and
// joints without strength make more of that in forty steps, as much as round-off has it: 1e-10, 7e-9, 4e-9, 2e-7 and
// 2e-8 with five kernels of a BLAS library (SkylakeX, Haswell, Sandybridge, Nehalem, Prescott).
double likeness(const RockKind& kind) { return std::string(kind.name) == "dry" ? 1e-5 : 1e-8; }

// Both take a step as long as they have as many contacts. Returns how many steps that was: round-off decides of a
// corner that just comes near enough to an edge whether it is a contact now or a step later. In the second half of the
// motion two dry rocks may part as well with the same contacts: seed 2 does in step 22, from 2e-15 m to 8e-7 m of 1.4
// mm, where the same passes find another answer. Why is not known.
int step_together(Simulation& removed, Simulation& never, double likeness) {
  int steps = 0;
  const auto alike = [&] { return removed.contacts().elements.size() == never.contacts().elements.size(); };
  const auto apart = [&] { return largest_difference(removed, never) >= likeness * largest_motion(never); };
  EXPECT_EQ(removed.step(), Status::ok);  // settles
  do {
    EXPECT_EQ(removed.step(), Status::ok) << removed.message();
    EXPECT_EQ(never.step(), Status::ok) << never.message();
    if (!alike() || (steps >= moving / 2 && apart())) break;
    ++steps;
    EXPECT_FALSE(apart()) << "after " << steps << " steps";
  } while (!never.finished() && !testing::Test::HasFailure());
  return steps;
}

TEST_P(ExcavatedRock, MovesAsIfTheOpeningHadAlwaysBeenThere) {
  int parted = 0;
  with_each_rock([&parted](int seed, const RockKind& kind) {
    Simulation never(model_of(seed, kind, Removed::never));
    Simulation removed(model_of(seed, kind, Removed::at_once));
    const int steps = step_together(removed, never, likeness(kind));
    EXPECT_GE(steps, moving / 2);
    if (steps < moving) ++parted;
    EXPECT_GT(largest_motion(never), 1e-5);
    EXPECT_LT(std::abs(removed.energy().relative_residual()), 1e-9);
    EXPECT_GT(removed.energy().removed, 0);
    expect_both_forms_of_release(removed);
  });
  EXPECT_LE(parted, 5);  // seen: none to two of 26, with the kernels of likeness()
}

TEST_P(ExcavatedRock, StaysWhileTheTractionsStay) {
  with_each_rock([](int seed, const RockKind& kind) {
    Simulation at_once(model_of(seed, kind, Removed::at_once));
    Simulation kept(model_of(seed, kind, Removed::kept));
    run_to_end(at_once);
    run_to_end(kept);
    EXPECT_LT(largest_motion(kept), 1e-10 * largest_motion(at_once));
    EXPECT_LT(std::abs(kept.energy().relative_residual()), 1e-9);
  });
}

TEST_P(ExcavatedRock, BalancesItsEnergyAndGoesOnToTheBitWhenItLetsGoSlowly) {
  with_each_rock([](int seed, const RockKind& kind) {
    const Model model = model_of(seed, kind, Removed::slowly);
    Simulation whole(model);
    Simulation first(model);
    const int stop = 1 + seed % 7;  // before the removal, at it, or after it
    for (int i = 0; i < stop - 1; ++i) ASSERT_EQ(first.step(), Status::ok);
    Simulation second(model);
    restore(second, first.state(), save(first));
    expect_same_end(second, whole);
    EXPECT_LT(std::abs(whole.energy().relative_residual()), 1e-9);
    EXPECT_LT(whole.energy().external_work, 0);  // what held the rock was drawn back
    expect_both_forms_of_release(whole);
  });
}

double largest_change_of_stress(const Simulation& simulation) {
  double most = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    most = std::max(most, (simulation.state().stress[i] - simulation.model().blocks[i].initial_stress).norm());
  return most;
}

TEST_P(ExcavatedRock, ThatNobodyTouchesKeepsAUniformStress) {
  with_each_rock([](int seed, const RockKind& kind) {
    for (const bool absorbing : {false, true}) {
      Simulation simulation(
          left_alone(seed, kind, {{"rock", rock_with_opening(seed, false)}}, uniform_field, absorbing));
      run_to_end(simulation);
      EXPECT_LT(largest_change_of_stress(simulation), 1e-10 * 5e6);
    }
  });
}

// Courses of equal rectangles: a joint has the mean of the stresses of its blocks, which is that of the field.
TEST_P(ExcavatedRock, OfRectanglesThatNobodyTouchesKeepsAStressThatGrowsWithDepth) {
  const json field = {{"surface", 5}, {"density", 2600}, {"k0", 0.6}};
  for (const char* pattern : {"stack", "running_bond"}) {
    const json grid = {
        {"grid", {{"columns", 6}, {"rows", 5}, {"block_width", 1}, {"block_height", 1}, {"pattern", pattern}}}};
    Simulation simulation(left_alone(0, GetParam(), grid, field, false));
    run_to_end(simulation);
    EXPECT_LT(largest_change_of_stress(simulation), 1e-10 * 2600 * 10 * 5) << pattern;
  }
}

// In other shapes a block's stress is wrong by what its field changes over a part of its size, whatever the depth,
// which leaves a part of the weight of the largest blocks out of balance: measured 0.12 to 0.92 of the largest one's.
TEST_P(ExcavatedRock, OfOtherShapesIsOutOfBalanceByAPartOfItsWeight) {
  for (const double depth : {10.0, 100.0}) {
    const json field = {{"surface", depth}, {"density", 2600}, {"k0", 0.8}};
    with_each_rock([&](int seed, const RockKind& kind) {
      const Model model = left_alone(seed, kind, {{"rock", rock_with_opening(seed, false)}}, field, false);
      double weight = 0;  // N, of the largest block
      for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) weight = std::max(weight, 10 * model.mass_of(i));
      double scale = weight;
      for (const InterfaceState& state : make_contacts(model).states)
        scale = std::max(scale, state.force.cwiseAbs().maxCoeff());
      for (const EdgeLoad& load : model.edge_loads)
        scale = std::max(scale, load.traction.cwiseAbs().maxCoeff() * (load.to - load.from).norm());
      EXPECT_LT(Simulation(model).out_of_balance() * scale, weight) << depth;
    });
  }
}

// The engine's own steps for rock that is let go at once, which grow; and all of them as short as the first.
Model loose_rock(int seed, bool growing) {
  const RockKind loose{"loose", {{"friction_angle", "12 deg"}}, "finite"};
  const json steps = {{{"name", "settle"}, {"integrator", "static"}},
                      {{"name", "let go"}, {"remove", {"opening"}}, {"duration", "60 ms"}}};
  Model model = parse_scene(scene_with_opening(seed, loose, false, steps).dump(), fmt::format("seed {}", seed));
  if (growing) return model;
  Stage& stage = model.stages[1];
  stage.dt = stage.chosen.dt.first_steps.dt;
  stage.chosen.dt.first_steps = {};
  return model;
}

double energy_let_go(const Simulation& simulation) {
  const EnergyLedger& energy = simulation.energy();
  return energy.friction + energy.kinetic + energy.radiated;
}

double largest_difference_of_present(const Simulation& a, const Simulation& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.model().blocks.size(); ++i)
    if (is_present(a, i))
      most = std::max(most, (a.state().displacement[i] - b.state().displacement[i]).head<2>().norm());
  return most;
}

// What friction took, what was radiated and what still moves is what was let go, and how far blocks have come is what
// it has done with them. Of rock that rings between its walls the longer steps take more (2 % of the sum, measured),
// and where blocks slide a small difference is made more of (up to 2.4 % of the motion; 15 % in a ninth rock that
// hardly moves).
TEST(GrowingSteps, MoveLooseRockAsShortOnesDo) {
  double let_go = 0;
  double let_go_by_short_ones = 0;
  for (int seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    Simulation growing(loose_rock(seed, true));
    Simulation steady(loose_rock(seed, false));
    run_to_end(growing);
    run_to_end(steady);
    EXPECT_NEAR(growing.state().time, steady.state().time, 1e-12);
    EXPECT_LT(4 * growing.state().step, steady.state().step);
    EXPECT_LT(std::abs(growing.energy().relative_residual()), 1e-9);
    let_go += energy_let_go(growing);
    let_go_by_short_ones += energy_let_go(steady);
    EXPECT_LT(largest_difference_of_present(growing, steady), 0.04 * largest_motion(steady));
  }
  EXPECT_NEAR(let_go / let_go_by_short_ones, 1, 0.04);
}

TEST(GrowingSteps, GoOnToTheBit) {
  for (int seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = loose_rock(seed, true);
    Simulation whole(model);
    for (int i = 0; i < 199 + 20 * seed; ++i)
      ASSERT_EQ(whole.step(), Status::ok);  // from the last one before they grow
    Simulation resumed(model);
    restore(resumed, whole.state(), save(whole));
    expect_same_end(resumed, whole);
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, ExcavatedRock, testing::ValuesIn(kinds),
                         [](const auto& kind) { return fmt::format("{}", kind.index); });

}  // namespace
}  // namespace dda
