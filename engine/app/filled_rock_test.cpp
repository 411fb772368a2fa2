// Rock filled with Voronoi cells settles and stands: dry grains between held walls, bonded ones around a tunnel. What
// is asked of each: it ends ok, nothing gains energy.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

class FilledRock : public CommandLine, public testing::WithParamInterface<int> {
 protected:
  void expect_to_stand(const json& scene) {
    write("rock.json", scene.dump());
    const Outcome run = call({"run", path("rock.json"), "--out", path("out"), "--quiet"});
    ASSERT_EQ(run.code, 0) << run.errors;
    const json summary = json::parse(text("out/summary.json"));
    EXPECT_EQ(summary["status"], "ok");
    const json& energy = summary["energy"];
    // As for rock cut by joints (rock_population_test.cpp): what comes from nowhere would be numerical and negative.
    EXPECT_GT(energy["numerical"].get<double>(), -1e-3 * energy["gravity_work"].get<double>());
    EXPECT_LT(std::abs(energy["residual_relative"].get<double>()), 1e-9);
  }
};

json scene_with(json rock, json joints) {
  rock["boundary"] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2600}, {"young", 10e9}, {"poisson", 0.2}}}}},
          {"joints", std::move(joints)},
          {"blocks", {{"rock", std::move(rock)}}},
          {"supports",
           {{{"edge", "bottom"}}, {{"edge", "left"}, {"hold", "normal"}}, {{"edge", "right"}, {"hold", "normal"}}}},
          {"gravity", 9.81},
          {"steps", {{{"integrator", "static"}}, {{"duration", 0.05}}}}};
}

TEST_P(FilledRock, OfDryGrainsSettles) {
  const json fill = {{"voronoi", {{"size", 1.4}, {"relax", 3}}}, {"joint", "grains"}};
  expect_to_stand(scene_with({{"seed", GetParam()}, {"fill", {fill}}}, {{"default", {{"friction_angle", "30 deg"}}},
                                                                        {"grains", {{"friction_angle", "35 deg"}}}}));
}

// Grains, rings and their joints hold together; a bedding plane does not.
TEST_P(FilledRock, OfBondedGrainsStandsAroundATunnel) {
  const json tunnel = {{"name", "tunnel"},
                       {"horseshoe", {{"foot", {5, 4}}, {"width", 3}, {"height", 3}}},
                       {"left_out", true},
                       {"rings", {{"count", 2}, {"thickness", 0.4}, {"joint", "intact"}}}};
  const json fill = {{"voronoi", {{"size", 1.6}, {"graded", {{"size", 0.6}}}}}, {"joint", "intact"}};
  const json bedding = {{"points", {{-1, 2}, {11, 3.1}}}, {"joint", "bedding"}};
  expect_to_stand(scene_with({{"seed", GetParam()}, {"openings", {tunnel}}, {"fill", {fill}}, {"lines", {bedding}}},
                             {{"default", {{"friction_angle", "30 deg"}}},
                              {"bedding", {{"friction_angle", "25 deg"}}},
                              {"intact", {{"bonded", true}}}}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, FilledRock, testing::Range(1, 7));

}  // namespace
}  // namespace dda
