// Runs in which stages take blocks out, put others in and put them back, shown by `dda view` and `dda report`, as one
// run and as branches that begin while blocks are away. The oracle: the stages of the scene, read here as lists of
// names.
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/app/command_line_test_support.h"
#include "engine/view/run_results.h"

namespace dda {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

constexpr int seeds = 20;
constexpr int last_stage = 4;        // all that was away has come by the one before, and what that removed comes back
constexpr double stage_time = 4e-3;  // s

json block(const std::string& name, double left, double bottom, double right, double top) {
  return {{"polygon", {{"name", name}, {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

struct Building {
  json scene;
  std::vector<Names> there;  // in each stage
};

json stage_of(int number, const Names& removed, const Names& added) {
  json stage = {{"name", "stage " + std::to_string(number)}, {"dt", "1 ms"}, {"duration", stage_time}};
  if (!removed.empty()) stage["remove"] = removed;
  if (!added.empty()) stage["add"] = added;
  return stage;
}

void move(const Names& names, Names& from, Names& to) {
  for (const std::string& name : names) {
    from.erase(name);
    to.insert(name);
  }
}

// Cubes in rows on a floor. A block is away at first if a stage adds it before any removes it.
Building building_of_lot(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto one_in = [&](unsigned count) { return random() % count == 0; };
  Building building;
  building.scene = {{"dda", 1},
                    {"gravity", 9.81},
                    {"materials", {{"rock", {{"density", 2600}, {"young", 1e9}, {"poisson", 0.2}}}}},
                    {"joints", {{"default", {{"friction_angle", "35 deg"}}}}},
                    {"blocks", {block("floor", -1, -1, 5, 0)}},
                    {"fixed", {"floor"}},
                    {"measurements", {{{"quantity", "contacts"}}}},
                    {"steps", json::array()}};
  Names there = {"floor"}, away;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      const std::string name = "cube " + std::to_string(column) + " " + std::to_string(row);
      building.scene["blocks"].push_back(block(name, column, row, column + 1, row + 1));
      (one_in(2) ? away : there).insert(name);
    }
  for (int number = 0; number <= last_stage; ++number) {
    Names removed, added;
    for (const std::string& name : away)
      if (number >= last_stage - 1 || one_in(3)) added.insert(name);
    for (const std::string& name : there)
      if (number < last_stage && name != "floor" && one_in(6)) removed.insert(name);
    if (number == 0) {
      added.clear();
      removed.clear();
    }
    move(added, away, there);
    move(removed, there, away);
    building.scene["steps"].push_back(stage_of(number, removed, added));
    building.there.push_back(there);
  }
  return building;
}

class Shown : public CommandLine {
 protected:
  void expect_shown(const std::string& folder) const {
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"view", path(folder)},
                                               {"report", path(folder)},
                                               {"view", path(folder), "--svg", "last", "--out", path(folder + ".svg")},
                                               {"view", path(folder), "--svg", "0", "--out", path(folder + ".svg")}}) {
      const Outcome outcome = call(command);
      EXPECT_EQ(outcome.code, 0) << command[0] << ": " << outcome.errors;
    }
  }

  // Frames at the moment when one stage ends and the next begins are left to either.
  void expect_frames(const std::string& folder, const std::vector<Names>& there) const {
    const RunResults results(path(folder));
    int compared = 0;
    for (std::size_t number = 0; number < results.times().size(); ++number) {
      const double stages = results.times()[number] / stage_time;
      if (stages - std::floor(stages) < 0.1 || stages - std::floor(stages) > 0.9) continue;
      const Frame frame = results.frame(number);
      Names shown;
      for (std::size_t i = 0; i < results.drawing().blocks(); ++i)
        if (is_present(frame, i)) shown.insert(results.drawing().names[i]);
      EXPECT_EQ(shown, there[static_cast<std::size_t>(stages)]) << folder << ", frame " << number;
      ++compared;
    }
    EXPECT_GT(compared, 2);
  }
};

class ShownBuilding : public Shown, public testing::WithParamInterface<int> {};

TEST_P(ShownBuilding, ShowsWhatIsThere) {
  const Building building = building_of_lot(GetParam());
  const Outcome run = run_scene(building.scene.dump(), "whole", {"--frames", "40"});
  ASSERT_EQ(run.code, 0) << run.errors;
  expect_frames("whole", building.there);
  expect_shown("whole");

  json begun = building.scene;
  begun["steps"].erase(last_stage);
  ASSERT_EQ(run_scene(begun.dump(), "begun").code, 0);
  const Outcome branch = run_scene(building.scene.dump(), "branch", {"--frames", "40", "--from", path("begun")});
  ASSERT_EQ(branch.code, 0) << branch.errors;
  expect_frames("branch", building.there);
  expect_shown("branch");
  EXPECT_EQ(json::parse(text("branch/summary.json"))["energy"], json::parse(text("whole/summary.json"))["energy"]);
}

INSTANTIATE_TEST_SUITE_P(OfLots, ShownBuilding, testing::Range(0, seeds));

// The example of the documents: a bench, and three lifts of two courses each, of which two come in later.
TEST_F(Shown, WallInLifts) {
  const std::string scene = std::string(DDA_EXAMPLES) + "/wall_in_lifts.json";
  ASSERT_EQ(call({"run", scene, "--out", path("lifts"), "--frames", "10", "--quiet"}).code, 0);
  expect_shown("lifts");
  const RunResults results(path("lifts"));
  const auto there = [&](std::size_t number) {
    const Frame frame = results.frame(number);
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < results.drawing().blocks(); ++i) count += is_present(frame, i) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(there(results.times().size() - 1), 28);
  EXPECT_EQ(there(0), 10);
}

}  // namespace
}  // namespace dda
