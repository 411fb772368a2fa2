// The rows and the frame at the end of a stage show that stage's end, whatever the next one does to the blocks: they
// are those of a run whose scene ends there.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

// A stack that a prop holds against a push, on a fixed floor. `steps` may remove "top", and the prop may end with a
// stage.
json propped_stack(bool bonded, const json& prop_ends) {
  const auto brick = [](const char* name, double bottom) {
    return json{{"polygon",
                 {{"name", name},
                  {"vertices", {{0, bottom}, {1, bottom}, {1, bottom + 0.5}, {0, bottom + 0.5}}},
                  {"initial_velocity", {0.01, 0}}}}};
  };
  json prop = {{"name", "prop"}, {"point", {1, 0.25}}, {"hold", "x"}, {"stiffness", 1e9}};
  prop.update(prop_ends);
  const json joint = {{"friction_angle", "30 deg"}, {"normal_spring", 1e10}, {"law", "classical"}, {"bonded", bonded}};
  return {{"dda", 1},
          {"gravity", 9.81},
          {"materials", {{"rock", {{"density", 2600}, {"young", 1e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", joint}}},
          {"blocks",
           {{{"polygon", {{"name", "floor"}, {"vertices", {{-1, -1}, {2, -1}, {2, 0}, {-1, 0}}}}}},
            brick("low", 0),
            brick("middle", 0.5),
            brick("top", 1)}},
          {"fixed", {"floor"}},
          {"supports", {prop}},
          {"loads", {{{"point", {0, 0.6}}, {"block", "middle"}, {"force", {"2 kN", 0}}}}},
          {"measurements",
           {{{"quantity", "velocity_x"}, {"block", "middle"}},
            {{"name", "prop"}, {"quantity", "reaction"}, {"support", "prop"}},
            {{"name", "floor"}, {"quantity", "reaction"}, {"block", "floor"}},
            {{"quantity", "stress_yy"}, {"block", "low"}},
            {{"quantity", "acceleration_y"}, {"block", "middle"}}}}};
}

json stage(const char* name, const json& more) {
  json all = {{"name", name}, {"kinematics", "small"}};
  all.update(more);
  return all;
}

const json moving = {{"dt", "1 ms"}, {"duration", "10 ms"}, {"integrator", "trapezoidal"}};
const json settling = {{"integrator", "static"}};
const json settling_in_steps = {{"integrator", "static"}, {"dt", "10 ms"}, {"duration", "30 ms"}};
const json settling_stuck = {
    {"integrator", "static"}, {"dt", "10 ms"}, {"duration", "30 ms"}, {"strength", "unlimited"}};

json removing(json stage) {
  stage["remove"] = {"top"};
  return stage;
}

class StageEndRows : public CommandLine {
 protected:
  void expect_rows_of_first_stages(json scene, const json& first, const json& next, const std::string& what) {
    SCOPED_TRACE(what);
    scene["steps"] = {stage("first", first)};
    ASSERT_EQ(run_scene(scene.dump(), "alone", {"--frame-interval", "5ms"}).code, 0);
    scene["steps"].push_back(stage("next", next));
    ASSERT_EQ(run_scene(scene.dump(), "both", {"--frame-interval", "5ms"}).code, 0);
    for (const char* file : {"histories.csv", "energies.csv"}) {
      const std::string alone = text(std::string("alone/") + file), both = text(std::string("both/") + file);
      EXPECT_TRUE(both.starts_with(alone)) << file << "\n" << alone << "\n" << both;
      EXPECT_GT(lines(both), lines(alone)) << file;
    }
    for (const char* folder : {"frames", "contacts"})
      for (const auto& [name, bytes] : files_below(std::string("alone/") + folder))
        EXPECT_TRUE(files_below(std::string("both/") + folder).at(name) == bytes) << folder << "/" << name;
  }
};

TEST_F(StageEndRows, AreThoseOfARunThatEndsThere) {
  const std::vector<std::pair<std::string, json>> firsts = {{"moving", moving},
                                                            {"settling", settling},
                                                            {"settling in steps", settling_in_steps},
                                                            {"settling stuck", settling_stuck}};
  const std::vector<std::pair<std::string, json>> nexts = {{"moving", moving},
                                                           {"settling", settling},
                                                           {"settling in steps", settling_in_steps},
                                                           {"moving without top", removing(moving)},
                                                           {"settling without top", removing(settling)}};
  for (const bool bonded : {true, false})
    for (const json& prop_ends :
         {json::object(), json{{"until_stage", "first"}}, json{{"until_stage", "first"}, {"release", true}}})
      for (const auto& [first_name, first] : firsts)
        for (const auto& [next_name, next] : nexts)
          expect_rows_of_first_stages(propped_stack(bonded, prop_ends), first, next,
                                      std::string(bonded ? "bonded, " : "dry, ") + prop_ends.dump() + ": " +
                                          first_name + ", then " + next_name);
}

std::vector<std::string> times_of(const std::string& rows) {
  std::vector<std::string> times;
  for (std::size_t at = rows.find('\n') + 1; at < rows.size(); at = rows.find('\n', at) + 1)
    times.push_back(rows.substr(at, rows.find(',', at) - at));
  return times;
}

// Ten steps of 1 ms and ten more: every seventh is 7 and 14.
TEST_F(StageEndRows, AreWrittenWhereTheyAreNotOneOfEveryK) {
  json scene = propped_stack(false, json::object());
  scene["steps"] = {stage("first", moving), stage("next", moving)};
  ASSERT_EQ(run_scene(scene.dump(), "all").code, 0);
  ASSERT_EQ(run_scene(scene.dump(), "some", {"--every", "7"}).code, 0);
  const std::vector<std::string> expected{"0", "0.007", "0.01", "0.014", "0.02"};
  for (const char* file : {"/histories.csv", "/energies.csv"}) {
    const std::string some = text(std::string("some") + file), all = text(std::string("all") + file);
    EXPECT_EQ(times_of(some), expected) << file;
    for (std::size_t at = 0; at < some.size(); at = some.find('\n', at) + 1)
      EXPECT_TRUE(contains(all, some.substr(at, some.find('\n', at) + 1 - at)))
          << file << " has every row of all steps";
  }
  const auto whole = results_without_times("some");
  const std::vector<std::string> again{"run",     path("some.json"), "--out", path("some"),
                                       "--quiet", "--every",         "7",     "--resume"};
  ASSERT_EQ(call(again).code, 0);
  EXPECT_EQ(results_without_times("some").at("histories.csv"), whole.at("histories.csv"));
  EXPECT_EQ(results_without_times("some").at("energies.csv"), whole.at("energies.csv"));
}

// A stone that no step can follow: the last whole step is in the rows, once, also when the run is tried again.
TEST_F(StageEndRows, AreThereOfARunThatEndsBeforeItsTime) {
  json scene = propped_stack(false, json::object());
  scene["steps"] = {stage("first", moving), stage("next", moving)};
  scene["steps"][1]["max_open_close_iterations"] = 1;
  scene["steps"][1]["max_step_reductions"] = 0;
  const int code = run_scene(scene.dump(), "some", {"--every", "7"}).code;
  ASSERT_NE(code, 0);
  const json summary = json::parse(text("some/summary.json"));
  const auto times = times_of(text("some/histories.csv"));
  EXPECT_NEAR(std::stod(times.back()), summary["time_s"].get<double>(), 1e-12);
  const std::string rows = text("some/histories.csv");
  ASSERT_EQ(call({"run", path("some.json"), "--out", path("some"), "--quiet", "--every", "7", "--resume"}).code, code);
  EXPECT_EQ(text("some/histories.csv"), rows);
}

}  // namespace
}  // namespace dda
