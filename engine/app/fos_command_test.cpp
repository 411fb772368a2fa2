// `dda fos` as from a shell.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// A box of 2 x 1 m on a held slope of 1 in 2, turned so that the slope is the x axis and gravity leans.
const std::string leaning_box = R"({"dda": 1, "gravity": [-4.0, -8.0],
 "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}},
 "joints": {"default": {"friction_angle": "45 deg"}},
 "blocks": [{"polygon": {"name": "ground", "vertices": [[-2, -1], [4, -1], [4, 0], [-2, 0]]}},
            {"polygon": {"name": "box", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}}],
 "fixed": ["ground"], "steps": {"dt": 1e-3, "duration": 1}})";

class FosCommand : public CommandLine {};

TEST_F(FosCommand, FindsTheFactorAndWhatMoves) {
  write("scene.json", leaning_box);
  const Outcome outcome = call({"fos", path("scene.json"), "--width", "0.001", "--out", path("out")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "factor of safety 1.999") || contains(outcome.out, "factor of safety 2.00"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "box moves towards 180.0 deg") ||
              contains(outcome.out, "box moves towards -180.0 deg"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.errors, "strength over 1: stands")) << outcome.errors;
  const nlohmann::json report = nlohmann::json::parse(text("out/fos.json"));
  EXPECT_NEAR(report["factor_of_safety"].get<double>(), 2, 0.002);
  EXPECT_LE(report["stands_at"], 2);
  EXPECT_GE(report["fails_at"], 2);
  EXPECT_EQ(report["moving_blocks"].size(), 1U);
  EXPECT_TRUE(contains(text("out/fos.svg"), "</svg>"));
}

TEST_F(FosCommand, FindsTheSameEveryTime) {
  write("scene.json", leaning_box);
  ASSERT_EQ(call({"fos", path("scene.json"), "--out", path("one")}).code, 0);
  ASSERT_EQ(call({"fos", path("scene.json"), "--out", path("two")}).code, 0);
  EXPECT_EQ(text("one/fos.json"), text("two/fos.json"));
}

TEST_F(FosCommand, WritesTheSameWithOneJobAndWithTwo) {
  write("scene.json", leaning_box);
  const auto outcome = [this](const std::string& jobs) {
    return call({"fos", path("scene.json"), "--jobs", jobs, "--out", path("of " + jobs)});
  };
  const Outcome one = outcome("1");
  const Outcome two = outcome("2");
  ASSERT_EQ(one.code, 0) << one.errors;
  EXPECT_EQ(one.errors, two.errors);
  EXPECT_EQ(text("of 1/fos.json"), text("of 2/fos.json"));
  ASSERT_EQ(outcome("6").code, 0);
  EXPECT_NEAR(nlohmann::json::parse(text("of 6/fos.json"))["factor_of_safety"].get<double>(), 2, 0.01);
}

// A ground that shakes is one at rest to the search, which says so, as of loads that come later.
TEST_F(FosCommand, SaysWhatItDoesNotSee) {
  nlohmann::json scene = nlohmann::json::parse(leaning_box);
  write("still.json", scene.dump());
  scene.erase("fixed");
  scene["supports"] = {
      {{"block", "ground"}, {"acceleration", {3, 0}}, {"history", {{"sine", {{"frequency", 2}, {"cycles", 3}}}}}}};
  scene["loads"] = {{{"point", {1, 1}}, {"force", {1e3, 0}}, {"history", {{"sine", {{"frequency", 2}}}}}}};
  write("shaken.json", scene.dump());
  const Outcome shaken = call({"fos", path("shaken.json"), "--out", path("shaken")});
  ASSERT_EQ(shaken.code, 0) << shaken.errors;
  EXPECT_TRUE(contains(shaken.out, "not in it: what a load on \"box\" and 1 more changes after 0 s")) << shaken.out;
  const Outcome still = call({"fos", path("still.json"), "--out", path("still")});
  EXPECT_FALSE(contains(still.out, "not in it")) << still.out;
  const auto report = [this](const std::string& of) { return nlohmann::json::parse(text(of + "/fos.json")); };
  EXPECT_EQ(report("shaken")["factor_of_safety"], report("still")["factor_of_safety"]);
  EXPECT_EQ(report("shaken")["not_seen"], (nlohmann::json{"a load on \"box\"", "the motion of \"ground\""}));
  EXPECT_TRUE(report("still")["not_seen"].empty());
}

// Joints that only exist in small kinematics are looked at in these.
TEST_F(FosCommand, FindsTheFactorOfProjectedJoints) {
  nlohmann::json scene = nlohmann::json::parse(leaning_box);
  scene["joints"]["default"]["law"] = "projected";
  scene["steps"] = {{"integrator", "static"}, {"kinematics", "small"}};
  write("scene.json", scene.dump());
  ASSERT_EQ(call({"fos", path("scene.json"), "--width", "0.001", "--out", path("out")}).code, 0);
  EXPECT_NEAR(nlohmann::json::parse(text("out/fos.json"))["factor_of_safety"].get<double>(), 2, 0.002);
}

// What the search does not take is said of the scene's file, and that the stages are those of the search.
TEST_F(FosCommand, SaysWhatTheSearchDoesNotTake) {
  nlohmann::json scene = nlohmann::json::parse(leaning_box);
  scene["gravity"] = 9.81;
  scene["blocks"][1]["polygon"]["vertices"] = {{-2, 0}, {4, 0}, {4, 1}, {-2, 1}};
  scene["viscous_boundaries"] = {{{"edge", "left"}, {"free_field", true}}, {{"edge", "right"}, {"free_field", true}}};
  write("scene.json", scene.dump());
  expect_refusal({"fos", path("scene.json"), "--out", path("out")},
                 path("scene.json") +
                     ": in the static stages of dda fos, viscous_boundaries is with free-field sides, expected sides "
                     "that are held: ");
}

TEST_F(FosCommand, RefusesWhatIsWrongBeforeItWritesAnything) {
  write("scene.json", leaning_box);
  expect_refusal({"fos", path("none.json")}, "the scene file is missing");
  expect_refusal({"fos", path("scene.json"), "--width", "0", "--out", path("out")}, "--width is 0, expected");
  for (const char* jobs : {"0", "-3", "1025"})
    expect_refusal({"fos", path("scene.json"), "--jobs", jobs},
                   "--jobs is " + std::string(jobs) + ", expected a whole number from 1 to 1024");
  expect_refusal({"fos", path("scene.json"), "--jobs", "many"}, "--jobs");
  expect_refusal({"fos", path("scene.json"), "--most", "nan", "--out", path("out")}, "--most is nan, expected");
  expect_refusal({"fos", path("scene.json"), "--out", path("scene.json")}, "which is a file");
  EXPECT_EQ(files_below(".").size(), 1U);
}

}  // namespace
}  // namespace dda
