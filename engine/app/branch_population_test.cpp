// Branches on a population: rock cut at random, walls and slopes settle in a scene that knows nothing of what comes
// later, and go on in another that has it. The oracle: the same two stages in one run, to the last bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "engine/core/error.h"
#include "engine/scene/scene.h"
#include "engine/simulation/branch.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/stopped_run_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 12;  // of each kind of scene

class Lot {
 public:
  explicit Lot(int seed) : random_(static_cast<unsigned>(seed)) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }
  int one_of(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937_64 random_;
};

json set(Lot& lot, double low, double high) {
  return {{"dip", {{"mean", fmt::format("{:.3f} deg", lot.between(low, high))}, {"deviation", "4 deg"}}},
          {"spacing", {{"mean", lot.between(0.9, 1.4)}, {"deviation", 0.2}}},
          {"joint", "default"}};
}

json rock(int seed, const json& boundary) {
  Lot lot(seed);
  return {{"rock",
           {{"boundary", boundary},
            {"joint_sets", {set(lot, 20, 80), set(lot, -60, 10)}},
            {"openings", {{{"name", "opening"}, {"circle", {{"centre", {3, 2.5}}, {"radius", 0.8}}}}}},
            {"seed", seed},
            {"merge", {{"area", 0.02}, {"angle", "8 deg"}}}}}};
}

json held(const char* name, double left, double bottom, double right, double top) {
  return {{"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

// What there is before anything happens.
json bare_scene(const std::string& kind, int seed) {
  json scene = {{"dda", 1}, {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}}};
  scene["gravity"] = 9.81;
  json& joint = scene["joints"]["default"];
  if (kind == "bonded") {
    joint = {{"bonded", true}};
  } else if (kind == "strong") {
    joint = {{"friction_angle", "35 deg"}, {"cohesion", "1 MPa"}, {"tensile_strength", "0.3 MPa"}};
  } else {
    joint = {{"friction_angle", "40 deg"}, {"residual_friction_angle", "35 deg"}};
  }
  scene["fixed"] = json::array({"base"});
  if (kind == "wall") {
    const json bricks = {
        {"columns", 4},    {"rows", 5}, {"block_width", 1}, {"block_height", 0.5}, {"pattern", "running_bond"},
        {"name", "bricks"}};
    scene["blocks"] = {{{"grid", bricks}}, held("base", -1, -1, 5, 0)};
  } else if (kind == "slope") {
    scene["blocks"] = {rock(seed, {{0, 0}, {8, 0}, {8, 1}, {6, 4}, {0, 4}}), held("base", -1, -1, 9, 0)};
  } else {
    scene["blocks"] = {rock(seed, {{0, 0}, {6, 0}, {6, 5}, {0, 5}}), held("base", -1, -1, 7, 0),
                       held("left", -1, 0, 0, 5), held("right", 6, 0, 7, 5)};
    scene["fixed"] = {"base", "left", "right"};
  }
  return scene;
}

// A slope is settled with contacts that stick, and slides afterwards.
json settle(const std::string& kind) {
  return {{"name", "settle"},
          {"integrator", "static"},
          {"duration", 4},
          {"strength", kind == "slope" ? "unlimited" : "joints"},
          {"kinematics", kind == "bonded" ? "small" : "finite"}};
}

// Drawn by lot: time step, integrator, and what begins to act with the stage.
json whole_scene(const std::string& kind, int seed, const json& settled) {
  Lot lot(1000 + seed);
  json scene = settled;
  json later = {{"name", "later"},
                {"dt", lot.between(1e-4, 4e-4)},
                {"duration", 8e-3},
                {"kinematics", kind == "bonded" ? "small" : "finite"}};
  const json integrators[] = {
      "trapezoidal", "thesis", {{"hht", 0.1}}, {{"generalized_alpha", 0.5}}, {{"generalized_alpha", 0}}};
  later["integrator"] = integrators[lot.one_of(5)];
  if (lot.one_of(2) == 0) later["damping_rate"] = 5;
  if (kind != "wall" && lot.one_of(2) == 0) later["remove"] = json::array({"opening"});
  scene["steps"].push_back(later);
  const double top = kind == "wall" ? 2.5 : kind == "slope" ? 4 : 5;
  scene["loads"] = {{{"edge", {{"from", {0, top}}, {"to", {2, top}}}},
                     {"force", {fmt::format("{} kN", lot.between(-40, 40)), 0}},
                     {"history", {{"decay", {{"decay_time", "2 ms"}, {"start", 4.001}}}}}}};
  scene["measurements"] = {{{"quantity", "displacement_y"}, {"block", "base"}}};
  return scene;
}

Model model_of(const json& scene) { return parse_scene(scene.dump(), "scene"); }

class Branches : public testing::TestWithParam<const char*> {};

TEST_P(Branches, GoOnAsOneRunWouldToTheBit) {
  const std::string kind = GetParam();
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    json scene = bare_scene(kind, seed);
    scene["steps"] = json::array({settle(kind)});
    Simulation settled(model_of(scene));
    run_to_stage(settled, 1);
    const Model later = model_of(whole_scene(kind, seed, scene));
    Simulation whole(later);
    run_to_stage(whole, 1);
    Simulation branch(later);
    begin_from(settled, branch);
    expect_same_course(branch, whole);
    EXPECT_GT(largest_speed(whole), 1e-5);  // something happens
  }
}

// The end of a stage that is not the last, as a run keeps it.
TEST_P(Branches, BeginAtTheEndOfAnyStage) {
  const std::string kind = GetParam();
  for (int seed = 1; seed <= seeds; seed += 4) {
    SCOPED_TRACE(seed);
    json scene = bare_scene(kind, seed);
    scene["steps"] = json::array({settle(kind)});
    const json first = whole_scene(kind, seed, scene);
    const json second = whole_scene(kind, seed + 1, scene);
    Simulation run(model_of(first));
    run_to_stage(run, 2);
    Simulation settled(model_of(first));
    bring_between_stages(model_of(first), 1, settled);
    Simulation whole(model_of(second));
    run_to_stage(whole, 1);
    Simulation branch(model_of(second));
    begin_from(settled, branch);
    expect_same_course(branch, whole);
    run_to_stage(settled, 2);  // and it is a run that goes on
    EXPECT_EQ(memory_of(settled), memory_of(run));
  }
}

// Points of a sweep over a later load: one settled state serves all, and is not used up.
TEST_P(Branches, ShareOneSettledState) {
  const std::string kind = GetParam();
  json scene = bare_scene(kind, 1);
  scene["steps"] = json::array({settle(kind)});
  Simulation settled(model_of(scene));
  run_to_stage(settled, 1);
  for (int point = 1; point <= 4; ++point) {
    SCOPED_TRACE(point);
    json each = whole_scene(kind, 1, scene);
    each["loads"][0]["force"][1] = -1e4 * point;
    Simulation whole(model_of(each));
    run_to_stage(whole, 1);
    Simulation branch(model_of(each));
    begin_from(settled, branch);
    expect_same_course(branch, whole);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Branches, testing::Values("dry", "strong", "bonded", "wall", "slope"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace dda
