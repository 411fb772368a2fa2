// Runs that stop when a stage has ended, or within a static one, on a population: rock cut at random on a base that is
// shaken, pushed or turned, held by a block or by springs. Who goes on from there comes to the same bits, energies
// among them, as the run that did not stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/random_rock_test_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 3;  // of each kind of motion

json sine(double frequency) { return {{"sine", {{"frequency", frequency}}}}; }

// Within the first stages in motion.
json ramp(double end) { return {{"table", {{0, 0}, {0.004, end}, {0.02, end}}}}; }

json supports_of(const std::string& kind, RockByLot& lot) {
  const double size = lot.between(0.2, 1.5);
  const json base = {{"block", "base"}};
  json support = base;
  if (kind == "shaken") support.update({{"acceleration", {size, 0}}, {"history", sine(lot.between(10, 60))}});
  if (kind == "driven") support.update({{"velocity", {0.1 * size, 0.02}}, {"history", sine(lot.between(10, 60))}});
  if (kind == "pushed") support.update({{"displacement", {1e-4 * size, 1e-4}}, {"history", ramp(1)}});
  if (kind == "turned") support.update({{"rotation", 1e-4 * size}, {"history", ramp(1)}});
  if (kind == "still") return json::array({base});
  if (kind == "sprung")
    support = {{"edge", {{"from", {-1, -1}}, {"to", {7, -1}}}},
               {"stiffness", "20 GN/m"},
               {"displacement", {1e-4 * size, 0}},
               {"history", ramp(1)}};
  return json::array({support});
}

json stage(const char* name, const char* integrator, double duration) {
  json settings = {{"name", name}, {"integrator", integrator}, {"kinematics", "finite"}};
  settings["on_unbalanced"] = "continue";
  if (std::string(integrator) == "static") return settings;
  settings.erase("on_unbalanced");
  settings.update({{"dt", 1e-4}, {"duration", duration}, {"integrator", {{"generalized_alpha", 0.7}}}});
  return settings;
}

json steps_by_lot(RockByLot& lot) {
  json dig = stage("dig", lot.between(0, 1) < 0.5 ? "static" : "dynamic", 1e-3);
  dig["remove"] = {"opening"};
  return {stage("settle", "static", 0), stage("rest", "static", 0), dig, stage("move", "dynamic", 1.5e-3)};
}

Model model_by_lot(const std::string& kind, int seed) {
  RockByLot lot(1000 + seed);
  json rock = rock_with_opening(seed, false);
  const json scene = {{"dda", 1},
                      {"gravity", 9.81},
                      {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
                      {"joints", {{"default", {{"friction_angle", "35 deg"}}}}},
                      {"blocks", {{{"rock", rock}}, held_wall("base", -1, -1, 7, 0)}},
                      {"supports", supports_of(kind, lot)},
                      {"steps", steps_by_lot(lot)}};
  return parse_scene(scene.dump(), "lot.json");
}

struct Stop {
  std::string where;
  std::size_t steps;  // that were done
  State state;
  std::vector<std::byte> snapshot;
};

// A run to its end, what it remembers after each step, and where it is stopped: between stages, where one has just
// begun, and after each tenth step.
struct Course {
  std::vector<std::vector<std::byte>> memories;
  std::vector<Stop> stops;
};

Course course_of(const Model& model) {
  Simulation run(model);
  Course course;
  const auto stop = [&](const char* where) {
    course.stops.push_back({where, course.memories.size() + (where[0] == 'b' ? 1 : 0), run.state(), save(run)});
  };
  run.watch().between = [&] { stop("between stages"); };
  while (!run.finished()) {
    const std::size_t stages = stages_done(run);
    if (run.step() != Status::ok) ADD_FAILURE() << run.message();
    course.memories.push_back(memory_of(run));
    if (stages_done(run) > stages || course.memories.size() % 10 == 0) stop("after a step");
  }
  return course;
}

void expect_to_go_on(const Model& model, const Course& course, const Stop& stop) {
  constexpr std::size_t looked_at = 3;
  Simulation resumed(model);
  restore(resumed, stop.state, stop.snapshot);
  for (std::size_t step = stop.steps; step < std::min(stop.steps + looked_at, course.memories.size()); ++step) {
    ASSERT_EQ(resumed.step(), Status::ok) << resumed.message();
    ASSERT_TRUE(memory_of(resumed) == course.memories[step])
        << stop.where << ", stopped after " << stop.steps << " steps, in step " << step + 1;
  }
}

class StoppedStages : public testing::TestWithParam<const char*> {};

TEST_P(StoppedStages, GoOnToTheLastBit) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = model_by_lot(GetParam(), seed);
    const Course course = course_of(model);
    ASSERT_GE(course.stops.size(), 8U);
    for (const Stop& stop : course.stops) expect_to_go_on(model, course, stop);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, StoppedStages,
                         testing::Values("shaken", "driven", "pushed", "turned", "still", "sprung"),
                         [](const auto& motion) { return std::string(motion.param); });

}  // namespace
}  // namespace dda
