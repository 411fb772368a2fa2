// Water in a joint that pushes a stone off, by lot. A run says so where the stone has left the joint; the oracle is how
// far the stone's middle has gone, as it slides without turning.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/random_rock_test_support.h"
#include "engine/app/run_warnings.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

using nlohmann::json;

struct Stone {
  double width, height, pressure, friction;  // m, m, Pa, degrees
};

Stone stone_by_lot(int seed) {
  RockByLot lot(seed);
  return {lot.between(3, 5), lot.between(2, 3), lot.between(10e3, 90e3), lot.between(15, 50)};
}

// A stone on the ground beside a wall, with water in the crack between wall and stone.
json scene_of(const Stone& stone) {
  const double end = 2 + stone.width;
  return {
      {"dda", 1},
      {"gravity", 9.81},
      {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
      {"joints",
       {{"default", {{"friction_angle", fmt::format("{:.2f} deg", stone.friction)}}},
        {"crack", {{"friction_angle", "5 deg"}}}}},
      {"joint_lines", {{{"points", {{2, 0}, {2, stone.height}}}, {"joint", "crack"}}}},
      {"blocks",
       {held_wall("ground", 0, -1, 20, 0),
        held_wall("wall", 0, 0, 2, stone.height),
        {{"polygon", {{"name", "stone"}, {"vertices", {{2, 0}, {end, 0}, {end, stone.height}, {2, stone.height}}}}}}}},
      {"fixed", {"walls"}},
      {"loads",
       {{{"edge", {{"joints", {"crack"}}}},
         {"pressure", {{"uniform", stone.pressure}}},
         {"from_stage", "wet"},
         {"until_stage", "wet"}}}},
      {"steps",
       {{{"name", "weight"}, {"integrator", "static"}},
        {{"name", "wet"}, {"dt", 1e-3}, {"duration", 0.25}},
        {{"name", "after"}, {"dt", 1e-3}, {"duration", 0.05}}}}};
}

std::string warning_on_water(const Simulation& simulation) {
  for (const std::string& warning : warnings_of(simulation))
    if (warning.find("water") != std::string::npos) return warning;
  return "";
}

double way_of_stone(const Simulation& simulation) { return simulation.state().displacement[2](0); }

Simulation run_of(const json& scene, double& way_when_wet) {
  Simulation simulation(parse_scene(scene.dump(), "lot.json"));
  int stage = 0;
  simulation.watch().at_end = [&] {
    if (++stage == 2) way_when_wet = way_of_stone(simulation);
  };
  while (!simulation.finished()) {
    if (simulation.step() == Status::ok) continue;
    ADD_FAILURE() << simulation.message();
    break;
  }
  simulation.watch().at_end = nullptr;
  return simulation;
}

TEST(WaterApart, IsSaidWhereAStoneHasLeftItsJoint) {
  int left = 0, stayed = 0;
  for (int seed = 0; seed < 60; ++seed) {
    const Stone stone = stone_by_lot(seed);
    double way = 0;
    const std::string warning = warning_on_water(run_of(scene_of(stone), way));
    const bool has_left = way > 0.01 * std::sqrt(std::min(stone.width, 2.0) * stone.height);
    ++(has_left ? left : stayed);
    EXPECT_EQ(!warning.empty(), has_left) << "seed " << seed << ", " << way << " m: " << warning;
    if (warning.empty()) continue;
    const std::string told = fmt::format("\"wall\" and \"stone\" were {:.3g} m", way);
    EXPECT_NE(warning.find(told), std::string::npos) << told << " not in: " << warning;
    EXPECT_NE(warning.find("at 0.25 s, when stage \"wet\" was over"), std::string::npos) << warning;
  }
  EXPECT_GE(left, 8);
  EXPECT_GE(stayed, 8);
}

// What the documents advise: the water ends before the stone has gone.
TEST(WaterApart, IsNotSaidWhereTheWaterEndsBefore) {
  json scene = scene_of({3, 2, 90e3, 15});
  scene["steps"][1]["duration"] = 0.01;
  scene["steps"][2]["duration"] = 0.3;
  double way = 0;
  const Simulation run = run_of(scene, way);
  EXPECT_EQ(warning_on_water(run), "");
}

}  // namespace
}  // namespace dda
