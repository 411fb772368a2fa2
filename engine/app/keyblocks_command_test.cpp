// `dda keyblocks` as from a shell.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// A tunnel under a wedge: joints at 60 degrees meet above it at the origin. The frame is held.
std::string tunnel(bool left_out) {
  return fmt::format(R"({{"dda": 1, "gravity": 9.81,
 "materials": {{"rock": {{"density": 2600, "young": 1e10, "poisson": 0.2}}}},
 "joints": {{"default": {{"friction_angle": "30 deg"}}}},
 "blocks": [{{"rock": {{"boundary": [[-6, -8], [6, -8], [6, 4], [-6, 4]],
   "lines": [{{"points": [[-6, -10.392304845413264], [2, 3.4641016151377544]], "joint": "default"}},
             {{"points": [[6, -10.392304845413264], [-2, 3.4641016151377544]], "joint": "default"}}],
   "openings": [{{"name": "tunnel", "rectangle": {{"foot": [0, -5], "width": 4, "height": 3}}, "left_out": {}}}]}}}}],
 "supports": [{{"edge": "left"}}, {{"edge": "right"}}, {{"edge": "top"}}, {{"edge": "bottom"}}],
 "steps": {{"dt": 1e-3, "duration": 1}}}})",
                     left_out);
}

class KeyBlocksCommand : public CommandLine {};

// The wedge has its tip at the origin and is cut off at y = -2, where it is 2 tan 30 either way.
TEST_F(KeyBlocksCommand, FindsTheWedgeAboveATunnel) {
  for (const bool left_out : {false, true}) {
    write("scene.json", tunnel(left_out));
    const Outcome outcome =
        call({"keyblocks", path("scene.json"), "--opening", "tunnel", "--fos", "2", "--out", path("out")});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_TRUE(contains(outcome.out, "key block, falls towards -90.0 deg, factor of safety 0")) << outcome.out;
    const nlohmann::json report = nlohmann::json::parse(text("out/keyblocks.json"));
    EXPECT_EQ(report["by_type"]["I"], 1);
    EXPECT_EQ(report["wanted_factor_of_safety"], 2);
    EXPECT_EQ(report["blocks_taken_out"] > 0, !left_out);
    const nlohmann::json& wedge = report["blocks"][0];
    const double area = 2 * 2 / std::sqrt(3.0);
    EXPECT_NEAR(wedge["area"].get<double>(), area, 1e-9);
    EXPECT_NEAR(wedge["bolts"]["force"].get<double>(), 2 * 2600 * 9.81 * area, 2e-3);
    EXPECT_EQ(wedge["removable"], true);
    EXPECT_TRUE(contains(text("out/keyblocks.svg"), "</svg>"));
  }
}

TEST_F(KeyBlocksCommand, WritesNothingUnlessAsked) {
  write("scene.json", tunnel(true));
  const Outcome outcome = call({"keyblocks", path("scene.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_FALSE(contains(outcome.out, "written"));
  EXPECT_EQ(files_below(".").size(), 1U);
}

// The scene that dda cut writes has the blocks of the opening as a group.
TEST_F(KeyBlocksCommand, TakesGroupsOfBlocksAsOpenings) {
  write("scene.json", tunnel(false));
  ASSERT_EQ(call({"cut", path("scene.json"), "--out", path("cut")}).code, 0);
  const Outcome from_rock = call({"keyblocks", path("scene.json"), "--opening", "tunnel"});
  const Outcome from_cut = call({"keyblocks", path("cut/scene.json"), "--opening", "tunnel"});
  EXPECT_EQ(from_rock.out, from_cut.out);
  EXPECT_TRUE(contains(from_cut.out, "key block")) << from_cut.out;
}

// In the scene that dda cut writes, a stage alone says that the group is an opening.
TEST_F(KeyBlocksCommand, TakesOutWhatStagesRemove) {
  std::string scene = tunnel(false);
  const std::string steps = R"("steps": {"dt": 1e-3, "duration": 1})";
  scene.replace(scene.find(steps), steps.size(),
                R"("steps": [{"integrator": "static"}, {"integrator": "static", "remove": ["tunnel"]}])");
  write("scene.json", scene);
  ASSERT_EQ(call({"cut", path("scene.json"), "--out", path("cut")}).code, 0);
  const Outcome from_rock = call({"keyblocks", path("scene.json")});
  EXPECT_TRUE(contains(from_rock.out, "key block")) << from_rock.out << from_rock.errors;
  EXPECT_EQ(call({"keyblocks", path("cut/scene.json")}).out, from_rock.out);
}

TEST_F(KeyBlocksCommand, BoltDirectionAndAcceleration) {
  write("scene.json", tunnel(true));
  const Outcome sideways = call({"keyblocks", path("scene.json"), "--opening", "tunnel", "--bolt-direction", "0deg"});
  EXPECT_TRUE(contains(sideways.out, "towards 0.0 deg")) << sideways.out;
  const Outcome up = call({"keyblocks", path("scene.json"), "--opening", "tunnel", "--acceleration", "0,20"});
  EXPECT_FALSE(contains(up.out, "key block")) << up.out;
}

// Merging takes the small wedge to a neighbour, and the report says that there was one.
TEST_F(KeyBlocksCommand, SaysWhatMergingDid) {
  std::string scene = tunnel(true);
  const std::string line = "\"openings\":";
  scene.replace(scene.find(line), line.size(), "\"merge\": {\"area\": 3}, " + line);
  write("scene.json", scene);
  const Outcome outcome = call({"keyblocks", path("scene.json"), "--opening", "tunnel", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "left 0 of type I (of 1 without it)")) << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(text("out/keyblocks.json"));
  EXPECT_EQ(report["by_type"]["I"], 0);
  EXPECT_EQ(report["by_type_without_merging"]["I"], 1);
}

TEST_F(KeyBlocksCommand, Refusals) {
  write("scene.json", tunnel(false));
  const std::string scene = path("scene.json");
  expect_refusal({"keyblocks"}, "scene is required");
  expect_refusal({"keyblocks", path("none.json")}, "the scene file is missing");
  expect_refusal(
      {"keyblocks", scene, "--opening", "tunnle", "--out", path("out")},
      "--opening is \"tunnle\", expected the name of an opening or of a group of blocks (\"tunnel\"?): tunnel");
  expect_refusal({"keyblocks", scene, "--fos", "0", "--out", path("out")},
                 "--fos is 0, expected a number from 0.01 to 1000");
  expect_refusal({"keyblocks", scene, "--fos", "nan"}, "--fos is nan, expected");
  expect_refusal({"keyblocks", scene, "--bolt-direction", "up"}, "--bolt-direction is \"up\", expected");
  expect_refusal({"keyblocks", scene, "--acceleration", "1"}, "--acceleration is 1, expected X,Y in m/s2");
  expect_refusal({"keyblocks", scene, "--acceleration", "1,nan"}, "--acceleration is 1,nan, expected X,Y in m/s2");
  write("file", "");
  expect_refusal({"keyblocks", scene, "--out", path("file")}, path("file"));
}

}  // namespace
}  // namespace dda
