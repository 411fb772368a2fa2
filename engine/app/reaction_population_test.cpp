// Ground reaction curves of dry rock cut at random: every point of a curve is what a run of a scene with that share
// alone comes to, and the wall comes in the farther the less is left on it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/random_rock_test_support.h"
#include "engine/reaction/ground_reaction.h"
#include "engine/scene/scene_parts.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 10;
const std::vector<double> shares{1, 0.7, 0.4, 0.1, 0};

json rock_of(int seed) {
  RockByLot lot(seed);
  const json opening = {{"name", "tunnel"},
                        {"circle", {{"centre", {lot.between(3.6, 4.4), 4}}, {"radius", lot.between(0.8, 1.3)}}}};
  return {{"boundary", {{0, 0}, {8, 0}, {8, 8}, {0, 8}}},
          {"joint_sets", {lot.joint_set(20, 80), lot.joint_set(-60, 10)}},
          {"openings", {opening}},
          {"seed", seed},
          {"merge", {{"area", 0.02}, {"angle", "8 deg"}}}};
}

// Under 1 MPa on top; `removal` is the second stage.
json scene_of(int seed, json removal) {
  removal.update({{"name", "open"}, {"integrator", "static"}});
  return {{"dda", 1},
          {"gravity", 9.81},
          {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", "30 deg"}}}}},
          {"blocks",
           {{{"rock", rock_of(seed)}},
            held_wall("left", -1, -1, 0, 8),
            held_wall("right", 8, -1, 9, 8),
            held_wall("floor", 0, -1, 8, 0)}},
          {"stress_field", {{"yy", -1e6}, {"xx", -1e6}, {"surface", 8}, {"density", 2600}}},
          {"loads", {{{"edge", {{"from", {0, 8}}, {"to", {8, 8}}}}, {"traction", {0, -1e6}}}}},
          {"fixed", json::array({"walls"})},
          {"steps", {{{"name", "in situ"}, {"integrator", "static"}}, removal}}};
}

SceneParts parts_of(const json& scene, int seed) {
  return parse_scene_parts(scene.dump(), fmt::format("seed {}", seed));
}

std::vector<int> tunnel_of(const SceneParts& scene) {
  std::vector<int> blocks;
  for (std::size_t i = 0; i < scene.groups.size(); ++i)
    if (scene.groups[i] == "tunnel") blocks.push_back(static_cast<int>(i));
  return blocks;
}

// A whole run in which `share` is left, with another time for it than curves take.
void expect_run_alone(int seed, const ReactionPoint& point, const OpeningWall& wall) {
  const json removal = {{"remove", {{"blocks", {"tunnel"}}, {"table", {{0, 1}, {0.5, point.share}}}}}, {"duration", 1}};
  Simulation run(parts_of(scene_of(seed, removal), seed).model);
  State settled;
  run.watch().between = [&] {
    if (stages_done(run) == 1) settled = run.state();
  };
  Status status = Status::ok;
  while (status == Status::ok && !run.finished()) status = run.step();
  ASSERT_EQ(status, point.status) << "seed " << seed << ", share " << point.share << ": " << run.message();
  const WallMotion motion = motion_of(wall, run.model(), settled, run.state());
  EXPECT_EQ(motion.mean, point.motion.mean) << "seed " << seed << ", share " << point.share;
  EXPECT_EQ(motion.largest, point.motion.largest) << "seed " << seed << ", share " << point.share;
}

TEST(ReactionPopulation, EveryPointIsARunWithThatShareAlone) {
  int ended = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const SceneParts scene = parts_of(scene_of(seed, {{"remove", json::array({"tunnel"})}}), seed);
    const ReactionCurve curve = ground_reaction(scene.model, {tunnel_of(scene), shares});
    ASSERT_EQ(curve.in_situ, Status::ok) << "seed " << seed << ": " << curve.message;
    EXPECT_NEAR(curve.pressure / 1e6, 1.1, 0.1)
        << "seed " << seed;  // 1 MPa and 4 m of rock, spread by the blocks' size
    double before = -1e-6;   // m: nothing moves at a share of 1
    for (const ReactionPoint& point : curve.points) {
      expect_run_alone(seed, point, curve.wall);
      if (!point.settles()) {
        ++ended;
        EXPECT_FALSE(point.reason.empty());
        continue;
      }
      EXPECT_GT(point.motion.mean, before) << "seed " << seed << ", share " << point.share;
      before = point.motion.mean;
    }
  }
  EXPECT_GT(ended, 0);  // some rocks fall: the population has both kinds
  EXPECT_LT(ended, seeds);
}

// The wall's mean displacement at the ends of static stages that let go a tenth after the other, the first nine of
// them.
std::vector<double> stage_after_stage(const Model& model, const OpeningWall& wall, Status& status) {
  Simulation run(model);
  State settled;
  std::vector<double> means;
  const auto note = [&] {
    if (stages_done(run) == 1) settled = run.state();
    if (stages_done(run) > 1) means.push_back(motion_of(wall, run.model(), settled, run.state()).mean);
  };
  run.watch().between = note;
  status = Status::ok;
  while (status == Status::ok && !run.finished()) status = run.step();
  return means;
}

json ten_stages(int seed) {
  json scene = scene_of(seed, {{"remove", {{"blocks", {"tunnel"}}, {"table", {{0, 1}, {10, 0}}}}}, {"duration", 1}});
  for (int i = 2; i <= 10; ++i)
    scene["steps"].push_back({{"name", fmt::format("tenth {}", i)}, {"integrator", "static"}, {"duration", 1}});
  return scene;
}

// Friction remembers its way: a share that is reached at once and one that is reached by tenths may differ. Here they
// do so by at most 0.3 %, and the same rocks fall at the same share.
TEST(ReactionPopulation, LettingGoByTenthsComesToTheSame) {
  for (int seed = 0; seed < seeds; ++seed) {
    const SceneParts scene = parts_of(scene_of(seed, {{"remove", json::array({"tunnel"})}}), seed);
    const ReactionCurve curve =
        ground_reaction(scene.model, {tunnel_of(scene), {0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0}});
    Status status = Status::ok;
    const std::vector<double> means = stage_after_stage(parts_of(ten_stages(seed), seed).model, curve.wall, status);
    EXPECT_EQ(status, curve.points.back().status) << "seed " << seed;
    ASSERT_EQ(means.size(), curve.points.size() - (status == Status::ok ? 0U : 1U)) << "seed " << seed;
    for (std::size_t i = 0; i < means.size(); ++i)
      EXPECT_NEAR(means[i] / curve.points[i].motion.mean, 1, 0.005) << "seed " << seed << ", tenth " << i + 1;
  }
}

}  // namespace
}  // namespace dda
