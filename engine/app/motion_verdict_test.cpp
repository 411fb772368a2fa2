// Runs in small kinematics whose blocks go too far for it.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

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

// The same scenes in finite kinematics are not judged so.
TEST_F(MotionVerdict, IsOfSmallKinematicsAlone) {
  json scene = box_on_floor(outline(2, 0, 1, 1), down, 3, "1 deg", "1 s");
  scene["steps"]["kinematics"] = "finite";
  expect(scene, 0, "");
}

}  // namespace
}  // namespace dda
