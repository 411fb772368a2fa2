// `dda run --from`: what it leaves, what it takes from the other run, and what it refuses.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

// Two bricks on a fixed floor.
json bricks(const json& steps) {
  const auto brick = [](const char* name, double bottom) {
    return json{
        {"polygon", {{"name", name}, {"vertices", {{0, bottom}, {1, bottom}, {1, bottom + 0.5}, {0, bottom + 0.5}}}}}};
  };
  return {{"dda", 1},
          {"gravity", 9.81},
          {"materials", {{"rock", {{"density", 2600}, {"young", 1e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", {{"friction_angle", "30 deg"}}}}},
          {"blocks",
           {{{"polygon", {{"name", "floor"}, {"vertices", {{-1, -1}, {2, -1}, {2, 0}, {-1, 0}}}}}},
            brick("low", 0),
            brick("high", 0.5)}},
          {"fixed", {"floor"}},
          {"measurements", {{{"quantity", "displacement_x"}, {"block", "high"}}, {{"quantity", "contacts"}}}},
          {"steps", steps}};
}

const json settle = {{"name", "settle"}, {"integrator", "static"}};
const json shake = {{"name", "shake"}, {"dt", "1 ms"}, {"duration", "20 ms"}};
const json rest = {{"name", "rest"}, {"dt", "2 ms"}, {"duration", "10 ms"}, {"integrator", "trapezoidal"}};

json pushed(json scene) {
  scene["loads"] = {{{"point", {0, 0.9}}, {"block", "high"}, {"force", {"20 kN", 0}}}};
  scene["loads"][0]["history"] = {{"decay", {{"decay_time", "5 ms"}, {"start", "1 ms"}}}};
  return scene;
}

int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class Branch : public CommandLine {
 protected:
  Outcome run(const json& scene, const std::string& folder, const std::vector<std::string>& options = {}) const {
    return run_scene(scene.dump(), folder, options);
  }
  [[nodiscard]] std::string rows_from(const std::string& folder, const std::string& time) const {
    const std::string all = text(folder + "/histories.csv");
    const auto row = all.rfind("\n" + time + ",");  // the last: stages that take no time have several
    return row == std::string::npos ? "no row" : all.substr(row);
  }
  void expect_no_branch(const json& scene, const std::string& from, const std::string& sentence) {
    write("scene.json", scene.dump());
    expect_refusal({"run", path("scene.json"), "--out", path("out"), "--from", path(from)}, sentence);
  }
};

TEST_F(Branch, HasTheRowsOfTheWholeRun) {
  const json scene = pushed(bricks({settle, shake, rest}));
  ASSERT_EQ(run(scene, "whole").code, 0);
  ASSERT_EQ(run(bricks({settle}), "settled").code, 0);
  ASSERT_EQ(run(scene, "branch", {"--from", path("settled")}).code, 0);
  EXPECT_GT(lines(rows_from("branch", "0")), 20);
  EXPECT_EQ(rows_from("branch", "0"), rows_from("whole", "0"));
  ASSERT_EQ(run(scene, "later", {"--from", path("branch") + ":shake"}).code, 0);
  EXPECT_EQ(rows_from("later", "0.02"), rows_from("whole", "0.02"));
  const json whole = json::parse(text("whole/summary.json"));
  for (const char* folder : {"branch", "later"}) {
    const json summary = json::parse(text(std::string(folder) + "/summary.json"));
    EXPECT_EQ(summary["energy"], whole["energy"]) << folder;
    EXPECT_EQ(summary["steps"], whole["steps"]) << folder;
  }
  EXPECT_EQ(json::parse(text("later/summary.json"))["from"], path("branch") + ":shake");
}

// A stage without dt takes no time: the stage before it, whether that moves or not, has a row of its own end. A branch
// has the same rows but for its first, which is of the beginning of its first stage.
TEST_F(Branch, HasTheRowsOfStagesThatTakeNoTime) {
  json again = settle, once_more = settle;
  again["name"] = "again";
  once_more["name"] = "once more";
  const json scene = pushed(bricks({settle, shake, again, once_more, rest}));
  ASSERT_EQ(run(scene, "whole", {"--frames", "3"}).code, 0);
  for (const char* file : {"histories.csv", "energies.csv"}) {
    const std::string whole = text(std::string("whole/") + file);
    EXPECT_EQ(count_of("\n0,", whole), 2) << file;     // the start, and the end of "settle"
    EXPECT_EQ(count_of("\n0.02,", whole), 3) << file;  // the ends of "shake", "again" and "once more"
    for (const char* stage : {"settle", "shake", "again", "once more"}) {
      ASSERT_EQ(run(scene, "branch", {"--from", path("whole") + ":" + stage, "--frames", "3"}).code, 0);
      const std::string branch = text(std::string("branch/") + file);
      const auto second_row = branch.find('\n', branch.find('\n') + 1);
      EXPECT_TRUE(whole.ends_with(branch.substr(second_row))) << file << " from " << stage;
    }
  }
}

// Remarks are on the scene, wherever a run of it begins. "low" lies under "high" until it is removed.
TEST_F(Branch, HasTheRemarksOfItsScene) {
  json without = bricks({settle, shake});
  without["steps"][1]["remove"] = {"low"};
  without["materials"]["rock"]["density"] = 26000;
  without.erase("measurements");
  ASSERT_EQ(run(without, "whole").code, 0);
  const auto remarks = [&](const char* folder) {
    return json::parse(text(std::string(folder) + "/summary.json"))["remarks"];
  };
  const json of_scene = remarks("whole");
  ASSERT_EQ(of_scene.size(), 1U) << of_scene;
  ASSERT_EQ(run(without, "branch", {"--from", path("whole") + ":settle"}).code, 0);
  EXPECT_EQ(remarks("branch"), of_scene);
  ASSERT_EQ(run(without, "whole", {"--resume"}).code, 0);
  EXPECT_EQ(remarks("whole"), of_scene);
}

TEST_F(Branch, GoesOnAfterAStop) {
  ASSERT_EQ(run(bricks({settle}), "settled").code, 0);
  const json scene = pushed(bricks({settle, shake}));
  ASSERT_EQ(run(scene, "branch", {"--from", path("settled"), "--frames", "4"}).code, 0);
  const auto before = files_below("branch");
  ASSERT_EQ(run(scene, "branch", {"--from", path("settled"), "--frames", "4", "--resume"}).code, 0);
  EXPECT_EQ(files_below("branch").at("histories.csv"), before.at("histories.csv"));
  EXPECT_EQ(files_below("branch").at("frames.pvd"), before.at("frames.pvd"));
  EXPECT_EQ(run(scene, "branch", {"--frames", "4", "--resume"}).code, 2);  // another request
}

// Five frames over what the branch itself lasts.
TEST_F(Branch, HasItsOwnFrames) {
  ASSERT_EQ(run(bricks({settle, shake}), "first", {"--frames", "4"}).code, 0);
  ASSERT_EQ(run(bricks({settle, shake, rest}), "branch", {"--from", path("first"), "--frames", "5"}).code, 0);
  EXPECT_TRUE(exists("branch/frames/000005.vtp"));
  EXPECT_FALSE(exists("branch/frames/000006.vtp"));
}

// The first frame of such a branch has no outline of the block.
TEST_F(Branch, IsShownWithoutBlocksThatWereRemovedBefore) {
  ASSERT_EQ(run(bricks({settle}), "settled").code, 0);
  json without = bricks({settle, shake});
  without["steps"][1]["remove"] = {"high"};
  without.erase("measurements");
  ASSERT_EQ(run(without, "branch", {"--from", path("settled"), "--frames", "4"}).code, 0);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"view", path("branch")},
        {"report", path("branch")},
        {"view", path("branch"), "--svg", "last", "--crosses", "--out", path("last.svg")}}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  }
  EXPECT_FALSE(contains(text("last.svg"), "nan"));
}

TEST_F(Branch, RefusesWhatMustNotDiffer) {
  ASSERT_EQ(run(bricks({settle, shake}), "first").code, 0);
  const json scene = bricks({settle, shake, rest});
  const auto with = [&](const char* pointer, const json& value) {
    json changed = scene;
    changed[json::json_pointer(pointer)] = value;
    return changed;
  };
  expect_no_branch(with("/materials/rock/young", 2e9), "first", "scene.json: materials.rock.young is 2000000000, ");
  expect_no_branch(with("/joints/default/spring_over_young", 5), "first",
                   "joints.default.spring_over_young is 5, expected none, as in the run to go on from");
  expect_no_branch(with("/joints/default/penalty", 4), "first",
                   "joints.default.law is that of the scheme (given, or chosen by what joints and stages say), "
                   "expected \"projected\", as in the run");
  expect_no_branch(with("/joints/default/dilation_angle", "5 deg"), "first",
                   "joints.default.dilation_angle is given, expected none (joints that dilate have springs");
  expect_no_branch(with("/joints/default/contact_damping", 0.1), "first",
                   "joints.default.contact_damping is 0.1, expected none, as in the run");
  expect_no_branch(with("/joints/default/normal_stiffness", "10 GPa/m"), "first",
                   "joints.default.normal_stiffness is 10000000000, expected none, as in the run");
  expect_no_branch(with("/joints/default/cohesion", 1e5), "first",
                   "joints.default is with cohesion or tensile strength");
  expect_no_branch(with("/blocks/1/polygon/vertices/0/0", 0.1), "first", "block \"low\" is of another outline");
  expect_no_branch(with("/fixed/0", "low"), "first", "fixed or supports is of another list of held blocks");
  expect_no_branch(with("/steps/0/name", "sit"), "first", "steps[0].name is sit, expected settle");
  expect_no_branch(with("/steps/1/dt", 2e-3), "first", "steps[1].dt is 0.002, expected 0.001");
  expect_no_branch(bricks({settle, shake}), "first", "steps[2] is missing");
  expect_no_branch(scene, "first:quake", "--from is stage \"quake\", expected one of \"settle\", \"shake\"");
  expect_no_branch(scene, "nowhere", "--from is " + path("nowhere"));
  json held = scene;
  held.erase("fixed");
  held["supports"] = {{{"block", "floor"}, {"displacement", {"1 mm", 0}}}};
  expect_no_branch(held, "first", "the held block \"floor\" is 0.001 m");
  EXPECT_EQ(run(scene, "first", {"--from", path("first")}).code, 2);
}

// Gravity may differ, the stress at the start may not, which goes by it where a density makes it.
TEST_F(Branch, SaysThatStressFollowsGravity) {
  json scene = bricks({settle, shake});
  scene["stress_field"] = {{"surface", 5}, {"density", 2600}, {"k0", 0.5}};
  ASSERT_EQ(run(scene, "first").code, 0);
  scene["steps"].push_back(rest);
  scene["gravity"] = 8;
  expect_no_branch(scene, "first", "gravity is another, and with it the stress at the start, expected");
}

TEST_F(Branch, RefusesOtherSprings) {
  json scene = bricks({settle, shake});
  scene["joints"]["default"]["spring_over_young"] = 10;
  ASSERT_EQ(run(scene, "first").code, 0);
  scene["steps"].push_back(rest);
  scene["joints"]["default"]["spring_over_young"] = 5;
  expect_no_branch(scene, "first", "joints.default.spring_over_young is 5, ");
}

// Springs that joints have from when they break are chosen by the pressure that a scene expects: where that is above
// E/100, the weight of a thousand such bricks.
TEST_F(Branch, RefusesOtherSpringsOfJointsThatMayBreak) {
  json scene = bricks({settle, shake});
  scene["joints"]["default"]["cohesion"] = "1 MPa";
  ASSERT_EQ(run(scene, "first").code, 0);
  scene["steps"].push_back(rest);
  ASSERT_EQ(run(scene, "same", {"--from", path("first")}).code, 0);
  scene["loads"] = {{{"block", "high"}, {"edge", "top"}, {"traction", {0, "-20 MPa"}}}};
  expect_no_branch(scene, "first", "of another law or stiffness");
  scene["joints"]["default"]["spring_over_young"] = 10;
  expect_no_branch(scene, "first", "joints.default");
}

TEST_F(Branch, TakesWhatMayDiffer) {
  ASSERT_EQ(run(bricks({settle, shake}), "first").code, 0);
  json scene = bricks({settle, shake, rest});
  scene["gravity"] = 5;
  scene["joints"]["default"]["friction_angle"] = "5 deg";
  scene["supports"] = {{{"name", "prop"}, {"point", {1, 0.75}}, {"hold", "x"}, {"stiffness", 1e9}}};
  scene["bolts"] = {{{"from", {0.5, 0.75}}, {"to", {0.5, 0.25}}, {"stiffness", 1e7}, {"pretension", "30 kN"}}};
  scene["measurements"] = {{{"quantity", "reaction"}, {"support", "prop"}},
                           {{"quantity", "bolt_force"}, {"bolt", "bolt 1"}},
                           {{"quantity", "bolt_elongation"}, {"bolt", "bolt 1"}}};
  scene["steps"] = {settle, rest};
  ASSERT_EQ(run(scene, "branch", {"--from", path("first") + ":settle"}).code, 0);
  // The prop begins without force, the bolt with its pretension, whatever the bricks have moved by before.
  std::istringstream row(rows_from("branch", "0"));
  for (const double expected : {0.0, 0.0, 0.0, 0.0, 30e3, 0.0}) {
    double value = 1;
    char comma = 0;
    row >> value >> comma;
    EXPECT_EQ(value, expected);
  }
  const json energy = json::parse(text("branch/summary.json"))["energy"];
  EXPECT_LT(std::abs(energy["residual_relative"].get<double>()), 1e-9);
}

TEST_F(Branch, BeginsOnlyWhereARunWentWell) {
  ASSERT_EQ(run(bricks({settle}), "settled").code, 0);
  json summary = json::parse(text("settled/summary.json"));
  summary["status"] = "gained_energy";
  write("settled/summary.json", summary.dump());
  expect_no_branch(bricks({settle, shake}), "settled", "whose run ended with: gained_energy");
  write("settled/run.json", "{}");
  expect_no_branch(bricks({settle, shake}), "settled", "what the run was asked for is damaged");
}

}  // namespace
}  // namespace dda
