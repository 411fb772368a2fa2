// Rock cut at random, stressed, whose opening is filled in a run, and walls with a part that is built later: bonded,
// with strength and dry, as drawn and moving. Oracles that share nothing with adding blocks: before, the same rock
// whose opening was left out; after, the ledger of energies, a branch, and a run that was stopped.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <ostream>
#include <random>
#include <string>

#include "engine/scene/scene.h"
#include "engine/simulation/branch.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 16;  // of each kind
constexpr int settling = 20, moving = 30;

struct Kind {
  const char* name;
  json joint;
  const char* kinematics;
};

// NOLINTNEXTLINE(readability-identifier-naming): gtest's
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

const Kind kinds[] = {
    {"bonded", {{"bonded", true}}, "small"},
    {"bonded moving", {{"bonded", true}}, "finite"},
    {"dry", {{"friction_angle", "40 deg"}}, "finite"},
    {"strong",
     {{"friction_angle", "35 deg"}, {"cohesion", "1 MPa"}, {"tensile_strength", "0.3 MPa"}, {"spring_over_young", 10}},
     "finite"},
    {"dry as drawn", {{"friction_angle", "40 deg"}}, "small"},
    {"projected", {{"friction_angle", "40 deg"}, {"law", "projected"}}, "finite"}};

json wall(double left, double bottom, double right, double top) {
  return {{"polygon",
           {{"name", fmt::format("wall {} {}", left, bottom)},
            {"group", "walls"},
            {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

json rock_of(int seed, bool left_out) {
  std::mt19937_64 random(static_cast<unsigned>(seed));
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  const auto set = [&](double low, double high) {
    return json{{"dip", {{"mean", fmt::format("{:.3f} deg", between(low, high))}, {"deviation", "4 deg"}}},
                {"spacing", {{"mean", between(0.9, 1.4)}, {"deviation", 0.2}}},
                {"joint", "default"}};
  };
  const json opening = {
      {"name", "opening"},
      {"left_out", left_out},
      {"circle", {{"centre", {between(2.6, 3.4), between(2.6, 3.4)}}, {"radius", between(0.8, 1.3)}}}};
  return {{"boundary", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}},
          {"joint_sets", {set(20, 80), set(-60, 10)}},
          {"openings", {opening}},
          {"seed", seed},
          {"merge", {{"area", 0.02}, {"angle", "8 deg"}}}};
}

json settle(const Kind& kind) {
  return {
      {"name", "settle"},        {"integrator", "static"},        {"dt", 1e-3},          {"duration", settling * 1e-3},
      {"strength", "unlimited"}, {"kinematics", kind.kinematics}, {"solver", "cholesky"}};
}

json motion(const Kind& kind, const char* name) {
  return {{"name", name},
          {"integrator", {{"generalized_alpha", 0.5}}},
          {"dt", 1e-4},
          {"duration", moving * 1e-4},
          {"kinematics", kind.kinematics},
          {"solver", "cholesky"}};
}

json scene_of(int seed, const Kind& kind, bool left_out) {
  json fill = motion(kind, "fill");
  if (!left_out) fill["add"] = json::array({"opening"});
  return {{"dda", 1},
          {"gravity", 10},
          {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", kind.joint}}},
          {"blocks",
           {{{"rock", rock_of(seed, left_out)}},
            wall(-1, -1, 7, 0),
            wall(-1, 6, 7, 7),
            wall(-1, 0, 0, 6),
            wall(6, 0, 7, 6)}},
          {"stress_field", {{"xx", "-3 MPa"}, {"yy", "-4 MPa"}, {"xy", "0.2 MPa"}}},
          {"fixed", json::array({"walls"})},
          {"steps", {settle(kind), fill, motion(kind, "after")}}};
}

Model model_of(const json& scene, int seed) { return parse_scene(scene.dump(), fmt::format("seed {}", seed)); }

void run_to_stage(Simulation& simulation, std::size_t stages) {
  while (stages_done(simulation) < stages) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

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

class RefilledRock : public testing::TestWithParam<Kind> {};

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
    Simulation first(model);
    const int stop = settling - 2 + seed % 7;  // before they come in, as they do, or after
    for (int i = 0; i < stop; ++i) ASSERT_EQ(first.step(), Status::ok) << first.message();
    Simulation second(model);
    restore(second, first.state(), save(first));
    run_to_stage(whole, 3);
    run_to_stage(second, 3);
    EXPECT_EQ(memory_of(second), memory_of(whole));
    EXPECT_LT(std::abs(whole.energy().relative_residual()), 1e-9);
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
    Simulation settled(settled_model);
    std::vector<std::byte> snapshot;
    State state;
    settled.watch().between = [&] {
      if (stages_done(settled) != 1) return;
      snapshot = save(settled);
      state = settled.state();
    };
    run_to_stage(settled, 1);
    Simulation between(settled_model);
    restore(between, state, snapshot);
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
