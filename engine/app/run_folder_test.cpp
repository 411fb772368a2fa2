// One run a folder: what a run finds there, what it leaves, and how it goes on.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/app/stopped_run.h"
#include "engine/record/folder_lock.h"

namespace dda {
namespace {

class RunFolder : public CommandLine {
 protected:
  [[nodiscard]] std::vector<std::string> run(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"run", path("scene.json"), "--out", path("results")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }
  void write_changed(const std::string& from, const std::string& to) const {
    std::string scene = bar_scene(3, 20);
    ASSERT_NE(scene.find(from), std::string::npos) << from;
    write("scene.json", scene.replace(scene.find(from), from.size(), to));
  }
};

TEST_F(RunFolder, TakesOneRunAtATime) {
  write("scene.json", bar_scene(3, 20));
  {
    const FolderLock other(path("results"));
    expect_refusal(run(), "--out is " + path("results") + ", to which a run of process ");
    EXPECT_EQ(files_below("results").size(), 1U);
  }
  EXPECT_EQ(call(run()).code, 0);
  EXPECT_FALSE(exists("results/run.lock"));
}

TEST_F(RunFolder, HoldsNothingOfAnEarlierRun) {
  write("scene.json", bar_scene(3, 20));
  ASSERT_EQ(call(run({"--frames", "4"})).code, 0);
  ASSERT_EQ(call({"view", path("results")}).code, 0);
  write("results/notes.txt", "mine");
  write("scene.json", bar_scene(4, 20));
  ASSERT_EQ(call(run({"--frames", "1"})).code, 0);
  std::vector<std::string> names;
  for (const auto& [name, content] : files_below("results")) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"checkpoint.bin", "contacts.pvd", "contacts/000000.vtp", "contacts/000001.vtp",
                                      "energies.csv", "frames.pvd", "frames/000000.vtp", "frames/000001.vtp",
                                      "histories.csv", "notes.txt", "run.json", "summary.json"}));
  ASSERT_EQ(call(run()).code, 0);
  EXPECT_FALSE(exists("results/frames.pvd"));
}

TEST_F(RunFolder, IsLookedAtBeforeTheRun) {
  write("scene.json", bar_scene(3, 20));
  std::filesystem::create_directories(path("results/histories.csv"));
  expect_refusal(run(), "where histories.csv is a directory");
  EXPECT_FALSE(exists("results/checkpoint.bin"));
}

TEST_F(RunFolder, SameRunsLeaveTheSameBytes) {
  constexpr int gained_energy = 3;  // the slab does, in contacts that open and close
  write("scene.json", restless_slab);
  ASSERT_EQ(call(run({"--frames", "2", "--quiet"})).code, gained_energy);
  const auto first = files_below("results");
  ASSERT_EQ(call(run({"--frames", "2", "--quiet"})).code, gained_energy);
  for (const auto& [name, content] : files_below("results")) {
    if (name == "summary.json") continue;  // holds run times
    EXPECT_TRUE(first.at(name) == content) << name << " differs";
  }
}

TEST_F(RunFolder, GoesOnOnlyWithTheSameRequest) {
  write("scene.json", bar_scene(3, 20));
  expect_refusal(run({"--resume"}), "--resume is asked for without " + path("results/checkpoint.bin"));
  EXPECT_FALSE(exists("results"));
  ASSERT_EQ(call(run({"--every", "2"})).code, 0);
  const auto before = files_below("results");
  const std::string began = ", with which the run in " + path("results") + " began\n";
  expect_refusal(run({"--resume"}), "--every is 1, expected 2" + began);
  expect_refusal(run({"--resume", "--every", "2", "--frames", "2"}), "--frames is 2, expected \"not given\"" + began);
  const auto refuse = [&](const std::string& from, const std::string& to, const std::string& part) {
    write_changed(from, to);
    expect_refusal(run({"--resume", "--every", "2"}), path("scene.json") + ": " + part + began);
  };
  refuse("[1.5, 0.5]", "[2.5, 0.5]", "measurements[0].point[0] is 2.5, expected 1.5");
  refuse("1 MN", "2 MN", "loads[0].force[0] is \"2 MN\", expected \"1 MN\"");
  refuse("1e-5", "2e-5", "steps.dt is 2e-05, expected 1e-05");
  refuse("\"kinematics\": \"small\"", "\"kinematics\": \"finite\"",
         "steps.kinematics is \"finite\", expected \"small\"");
  refuse("\"length\": 3", "\"length\": 4", "blocks.bar.length is 4, expected 3");
  refuse("\"poisson\": 0.25", "\"poisson\": 0.25, \"plane\": \"strain\"",
         "materials.rock.plane is \"strain\", expected missing");
  refuse(", \"kinematics\": \"small\"", "", "steps.kinematics is missing, expected \"small\"");
  EXPECT_EQ(files_below("results"), before);
  write("results/run.json", "{}");
  write("scene.json", bar_scene(3, 20));
  expect_refusal(run({"--resume", "--every", "2"}), "run.json: what the run was asked for is damaged");
}

// Under a static stage contacts stick, after it they slide: the rule of the stage goes on with the run.
constexpr auto sliding_block = R"({"dda": 1, "gravity": 10,
 "materials": {"rock": {"density": 2500, "young": "1 GPa", "poisson": 0}},
 "joints": {"default": {"friction_angle": "20 deg"}},
 "blocks": [{"polygon": {"name": "slope", "vertices": [[0, 0], [8, 0], [0, 6]]}},
            {"polygon": {"name": "block", "vertices": [[1.6, 4.8], [2.4, 4.2], [3, 5], [2.2, 5.6]]}}],
 "supports": [{"block": "slope"}],
 "measurements": [{"quantity": "displacement_x", "block": "block"}],
 "steps": [{"name": "gravity", "integrator": "static", "dt": "1 ms", "duration": "10 ms", "strength": "unlimited"},
           {"name": "slide", "dt": "1 ms", "duration": "100 ms"}]})";

TEST_F(RunFolder, ASlidingBlockGoesOnSliding) {
  write("scene.json", sliding_block);
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("whole"), "--frame-interval", "10ms"}).code, 0);
  leave_stopped_run(path("scene.json"), path("results"), 0.01, 50);
  ASSERT_EQ(call(run({"--frame-interval", "10ms", "--resume"})).code, 0);
  EXPECT_EQ(text("results/histories.csv"), text("whole/histories.csv"));
  const std::string rows = text("whole/histories.csv");
  EXPECT_GT(std::stod(rows.substr(rows.rfind(',') + 1)), 0.01) << "it slides";
}

TEST_F(RunFolder, AFinishedRunThatGoesOnChangesNoResult) {
  write("scene.json", bar_scene(3, 20));
  ASSERT_EQ(call(run({"--frames", "2"})).code, 0);
  auto before = files_below("results");
  const Outcome outcome = call(run({"--frames", "2", "--resume"}));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "nothing left to step"));
  EXPECT_TRUE(contains(outcome.out, "resumed after 20"));
  auto after = files_below("results");
  for (auto* files : {&before, &after})
    for (const char* name : {"summary.json", "checkpoint.bin"}) files->erase(name);  // run times and counters
  EXPECT_EQ(before, after);
}

}  // namespace
}  // namespace dda
