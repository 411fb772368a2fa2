// Runs whose blocks go too far: for small kinematics, or from what they are bonded to.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/app/run_verdict.h"
#include "engine/scene/scene.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

using nlohmann::json;

json outline(double left, double bottom, double width, double height) {
  return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

// A box on, or above, a fixed floor of 4 m, thrown to the right.
json box_on_floor(const json& box, const json& gravity, double velocity, const char* friction, const char* duration) {
  const json stone = {{"name", "box"}, {"vertices", box}, {"initial_velocity", {velocity, 0}}};
  return {{"dda", 1},
          {"gravity", gravity},
          {"materials", {{"rock", {{"density", 2600}, {"young", "1 GPa"}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", friction}, {"law", "classical"}}}}},
          {"blocks", {{{"polygon", {{"name", "floor"}, {"vertices", outline(0, -1, 4, 1)}}}}, {{"polygon", stone}}}},
          {"fixed", {"floor"}},
          {"steps", {{"dt", "1e-2 s"}, {"duration", duration}, {"kinematics", "small"}}}};
}

const json down = {0, -9.81};

class MotionVerdict : public CommandLine {
 protected:
  void expect(const json& scene, int code, const std::string& part) const {
    const Outcome outcome = run_scene(scene.dump(), "box");
    EXPECT_EQ(outcome.code, code) << outcome.errors;
    if (part.empty()) {
      EXPECT_EQ(outcome.errors, "");
    } else {
      EXPECT_TRUE(contains(outcome.errors, part)) << outcome.errors;
      EXPECT_TRUE(contains(outcome.errors, "block \"box\" at (")) << outcome.errors;
      EXPECT_TRUE(contains(outcome.errors, "\"kinematics\": \"finite\"")) << outcome.errors;
      EXPECT_EQ(contains(outcome.errors, "warning: kinematics are small"), code == 0) << outcome.errors;
    }
  }
};

// In it at the end of the run, or already beyond it.
TEST_F(MotionVerdict, SaysThatABlockFellThroughAnother) {
  for (const char* duration : {"0.4 s", "0.8 s"})
    expect(box_on_floor(outline(1, 0.5, 1, 1), down, 0, "30 deg", duration), 3, "\"floor\", 20 % of the thinner one");
}

// Its middle leaves the floor at 1.5 m, its tail at 2 m.
TEST_F(MotionVerdict, SaysThatABlockSlidOffItsFloor) {
  expect(box_on_floor(outline(2, 0, 1, 1), down, 3, "1 deg", "1 s"), 3, "beyond the end of their common face");
  expect(box_on_floor(outline(2.9, 0, 1, 1), down, 1, "1 deg", "0.25 s"), 0, "has slid by 0.2");
}

TEST_F(MotionVerdict, SaysThatABlockTurned) {
  expect(box_on_floor(outline(2, 0, 0.3, 2), {4, -9}, 0, "60 deg", "1 s"), 3, "has turned by");
  expect(box_on_floor(outline(2, 0, 0.3, 2), {4, -9}, 0, "60 deg", "0.25 s"), 0, "of the length of that");
}

// On a fixed floor that is long enough a block slides rightly, however far; nor is anything said of rest.
TEST_F(MotionVerdict, SaysNothingOfMotionsThatAreRight) {
  expect(box_on_floor(outline(0, 0, 0.4, 0.4), down, 3, "1 deg", "1 s"), 0, "");
  expect(box_on_floor(outline(2, 0, 1, 1), down, 0, "30 deg", "0.3 s"), 0, "");
}

// A gate that is driven through the floor, as no dt and no joint can mend.
TEST_F(MotionVerdict, SaysThatHeldBlocksAreDrivenIntoEachOther) {
  json scene = box_on_floor(outline(1, 0.5, 1, 0.4), {0, 0}, 0, "30 deg", "1 s");
  scene["blocks"][1]["polygon"].erase("initial_velocity");
  scene["supports"] = {{{"block", "box"}, {"displacement", {0, -0.52}}, {"history", {{"table", {{0, 0}, {1, 1}}}}}}};
  scene["steps"].erase("kinematics");
  const Outcome outcome = run_scene(scene.dump(), "gate");
  EXPECT_TRUE(contains(outcome.errors, "both are held, so that nothing keeps them apart but their motions"))
      << outcome.errors;
  EXPECT_FALSE(contains(outcome.errors, "take stiffer joints")) << outcome.errors;
}

// Thrown over a wall: not on the straight way.
TEST_F(MotionVerdict, FollowsTheWayThatBlocksTake) {
  json scene = box_on_floor(outline(1, 1, 0.5, 0.5), down, 7, "0 deg", "1.4 s");
  scene["blocks"][0]["polygon"]["vertices"] = outline(0, -1, 12, 1);
  scene["blocks"][1]["polygon"]["initial_velocity"] = {7, 7};
  scene["blocks"].push_back({{"polygon", {{"name", "wall"}, {"vertices", outline(5, 0, 0.5, 2)}}}});
  scene["fixed"].push_back("wall");
  expect(scene, 0, "");
  scene["blocks"][2]["polygon"]["vertices"] = outline(5, 0, 0.05, 4);  // through it, in steps of twice its thickness
  expect(scene, 3, "\"wall\", 20 % of the thinner one");
}

// In a scene where nothing can change there is no contact to be found either.
TEST_F(MotionVerdict, SaysWhatMayHaveHappenedOnStraightWays) {
  json scene = box_on_floor(outline(1, 1, 0.5, 0.5), {0, 0}, 7, "0 deg", "1.4 s");
  scene["joints"]["default"] = {{"bonded", true}};
  scene["blocks"].push_back({{"polygon", {{"name", "wall"}, {"vertices", outline(5, 0, 0.5, 4)}}}});
  expect(scene, 0, "may have been deeper than");
}

// Whatever comes after it, a stage in small kinematics is judged by its own end.
TEST_F(MotionVerdict, IsOfEveryStageInSmallKinematics) {
  const json fall = box_on_floor(outline(1, 0.5, 1, 1), down, 0, "30 deg", "0.8 s");
  const json small = fall["steps"];
  json finite = small;
  finite["kinematics"] = "finite";
  finite["duration"] = "0.05 s";
  json rest = small;
  rest["duration"] = "0.02 s";
  rest["kinematics"] = "finite";
  json scene = fall;
  const auto stages = [](json first, json second) {
    first["name"] = "first";
    second["name"] = "second";
    return json::array({first, second});
  };
  scene["steps"] = stages(small, finite);
  expect(scene, 3, "\"floor\", 20 % of the thinner one");
  scene["steps"] = stages(rest, small);
  expect(scene, 3, "\"floor\", 20 % of the thinner one");
  scene["steps"] = stages(rest, finite);
  expect(scene, 0, "");
}

// Stopped on the way and gone on with, it knows what came before.
TEST_F(MotionVerdict, IsKeptInCheckpoints) {
  json scene = box_on_floor(outline(1, 0.5, 1, 1), down, 0, "30 deg", "0.8 s");
  json small = scene["steps"], finite = scene["steps"];
  small["name"] = "small";
  finite["name"] = "finite";
  finite["kinematics"] = "finite";
  finite["duration"] = "0.05 s";
  scene["steps"] = json::array({small, finite});
  Simulation whole(parse_scene(scene.dump(), "box.json"));
  Simulation rest(parse_scene(scene.dump(), "box.json"));
  while (stages_done(whole) == 0) ASSERT_EQ(whole.step(), Status::ok);
  restore(rest, whole.state(), save(whole));
  while (!rest.finished()) ASSERT_EQ(rest.step(), Status::ok);
  EXPECT_EQ(judge_motion(rest).status, Status::inaccurate);
}

// The same scenes in finite kinematics are not judged so.
TEST_F(MotionVerdict, IsOfSmallKinematicsAlone) {
  json scene = box_on_floor(outline(2, 0, 1, 1), down, 3, "1 deg", "1 s");
  scene["steps"]["kinematics"] = "finite";
  expect(scene, 0, "");
}

class StretchedBond : public CommandLine {};

// A block as soft as jelly hangs from a roof, a dry wall stands beside it. It ended the program with "BlockMatrix: no
// block (1, 0)" and code 1, as the two blocks were no longer a pair of the contact search.
TEST_F(StretchedBond, IsSteppedOnHoweverFarItsBlocksAre) {
  const Outcome outcome = run_scene(R"({"dda": 1, "gravity": 10,
 "materials": {"jelly": {"density": 2000, "young": 3e4, "poisson": 0}},
 "joints": {"default": {"friction_angle": "30 deg"}, "glue": {"bonded": true}},
 "blocks": [{"polygon": {"name": "roof", "vertices": [[0, 1], [1, 1], [1, 2], [0, 2]]}},
            {"polygon": {"name": "hung", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
            {"grid": {"name": "wall", "origin": [5, 0], "columns": 1, "rows": 2, "block_width": 1, "block_height": 1}}],
 "joint_pairs": [{"between": ["roof", "hung"], "joint": "glue"}],
 "fixed": ["roof", "wall 1.1"],
 "loads": [{"edge": {"from": [0, 0], "to": [1, 0]}, "block": "hung", "traction": [0, -60000]}],
 "steps": {"dt": 2e-3, "duration": 1}})",
                                    "out");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_FALSE(contains(outcome.errors, "BlockMatrix")) << outcome.errors;
  EXPECT_NE(nlohmann::json::parse(text("out/summary.json"))["status"], "ok");
}

}  // namespace
}  // namespace dda
