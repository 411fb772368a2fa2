// Rock cut at random, stressed, whose opening is filled in a run, and walls with a part that is built later: bonded,
// with strength and dry, as drawn and moving. Oracles that share nothing with adding blocks: before, the same rock
// whose opening was left out; after, the ledger of energies, a branch, and a run that was stopped.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/random_rock_test_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/branch.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/stopped_run_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 16;  // of each kind
constexpr int settling = 20, moving = 30;

const RockKind kinds[] = {
    {"bonded", {{"bonded", true}}, "small"},
    {"bonded moving", {{"bonded", true}}, "finite"},
    {"dry", {{"friction_angle", "40 deg"}}, "finite"},
    {"strong",
     {{"friction_angle", "35 deg"}, {"cohesion", "1 MPa"}, {"tensile_strength", "0.3 MPa"}, {"spring_over_young", 10}},
     "finite"},
    {"dry as drawn", {{"friction_angle", "40 deg"}}, "small"},
    {"projected", {{"friction_angle", "40 deg"}, {"law", "projected"}}, "finite"}};

json settle(const RockKind& kind) {
  return {
      {"name", "settle"},        {"integrator", "static"},        {"dt", 1e-3},          {"duration", settling * 1e-3},
      {"strength", "unlimited"}, {"kinematics", kind.kinematics}, {"solver", "cholesky"}};
}

json scene_of(int seed, const RockKind& kind, bool left_out) {
  json fill = motion_of(kind, "fill", moving);
  if (!left_out) fill["add"] = json::array({"opening"});
  json scene = scene_with_opening(seed, kind, left_out, {settle(kind), fill, motion_of(kind, "after", moving)});
  scene["gravity"] = 10;
  return scene;
}

Model model_of(const json& scene, int seed) { return parse_scene(scene.dump(), fmt::format("seed {}", seed)); }

// Largest difference of the motions of blocks of one place, as a share of the largest motion.
double difference(const Simulation& filled, const Simulation& never) {
  double most = 0, largest = 0;
  for (std::size_t i = 0; i < filled.model().blocks.size(); ++i)
    for (std::size_t j = 0; j < never.model().blocks.size(); ++j) {
      const AreaMoments& one = filled.model().blocks[i].moments;
      const AreaMoments& other = never.model().blocks[j].moments;
      if ((one.centroid - other.centroid).norm() > 1e-9 || std::abs(one.area - other.area) > 1e-9) continue;
      most = std::max(most, (filled.state().displacement[i] - never.state().displacement[j]).head<2>().norm());
      largest = std::max(largest, never.state().displacement[j].head<2>().norm());
    }
  EXPECT_GT(largest, 1e-6);
  return most / largest;
}

class RefilledRock : public testing::TestWithParam<RockKind> {};

TEST_P(RefilledRock, IsRockWithAnOpeningBefore) {
  int differ = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    Simulation filled(model_of(scene_of(seed, GetParam(), false), seed));
    Simulation never(model_of(scene_of(seed, GetParam(), true), seed));
    for (int i = 0; i < settling - 1; ++i) {
      ASSERT_EQ(filled.step(), Status::ok) << filled.message();
      ASSERT_EQ(never.step(), Status::ok) << never.message();
    }
    if (difference(filled, never) > 1e-8) ++differ;
  }
  EXPECT_LE(differ, 0);
}

TEST_P(RefilledRock, BalancesItsEnergyAndGoesOnToTheBit) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = model_of(scene_of(seed, GetParam(), false), seed);
    Simulation whole(model);
    const int stop = settling - 2 + seed % 7;  // before they come in, as they do, or after
    expect_same_when_stopped(model, 0, stop, whole);
    EXPECT_EQ(whole.energy().removed, 0);
  }
}

// The fill of the other run waits for a stage that it does not come to.
TEST_P(RefilledRock, CanBeABranch) {
  for (int seed = 1; seed <= seeds; seed += 3) {
    SCOPED_TRACE(seed);
    json other = scene_of(seed, GetParam(), false);
    std::swap(other["steps"][1]["name"], other["steps"][2]["name"]);
    other["steps"][2]["add"] = other["steps"][1]["add"];
    other["steps"][1].erase("add");
    Simulation whole(model_of(scene_of(seed, GetParam(), false), seed));
    run_to_stage(whole, 1);
    const Model settled_model = model_of(other, seed);
    Simulation between(settled_model);
    bring_between_stages(settled_model, 1, between);
    Simulation branch(model_of(scene_of(seed, GetParam(), false), seed));
    begin_from(between, branch);
    run_to_stage(whole, 3);
    run_to_stage(branch, 3);
    EXPECT_EQ(memory_of(branch), memory_of(whole));
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, RefilledRock, testing::ValuesIn(kinds),
                         [](const auto& kind) { return fmt::format("{}", kind.index); });

}  // namespace
}  // namespace dda
