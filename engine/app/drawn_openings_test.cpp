// Rock with openings drawn along joints, but for round-off, is cut, checked and run.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/cutting/lattice_plans_test_support.h"

namespace dda {
namespace {

nlohmann::json places_of(const std::vector<Vec2>& points) {
  nlohmann::json places = nlohmann::json::array();
  for (const Vec2& point : points) places.push_back({point.x(), point.y()});
  return places;
}

// A joint that no blocks have is refused: only those of the lattice have names.
nlohmann::json scene_of(const RockPlan& plan) {
  nlohmann::json rock = {{"boundary", places_of(plan.boundary)}};
  for (const PlanLine& line : plan.lines) {
    const bool is_named = line.joint == "first" || line.joint == "second";
    rock["lines"].push_back({{"points", places_of(line.points)}, {"joint", is_named ? line.joint : "default"}});
  }
  for (const PlanOpening& opening : plan.openings)
    rock["openings"].push_back(
        {{"name", opening.name}, {"polygon", places_of(opening.outline)}, {"left_out", opening.left_out}});
  const nlohmann::json friction = {{"friction_angle", "35 deg"}};
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2600}, {"young", 10e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", friction}, {"first", friction}, {"second", friction}}},
          {"blocks", {{"rock", rock}}},
          {"gravity", 9.81},
          {"steps", {{"dt", 1e-4}, {"duration", 3e-4}}}};
}

class DrawnOpenings : public CommandLine {};

TEST_F(DrawnOpenings, AreCutCheckedAndRun) {
  const double errors[] = {0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-9};
  for (unsigned i = 0; i < std::size(errors); ++i) {
    SCOPED_TRACE(i);
    const RockPlan plan = LatticePlanMaker(50 + i, errors[i]).make().plan;
    const std::string folder = "out" + std::to_string(i);
    write("plan.json", scene_of(plan).dump());
    const Outcome cut = call({"cut", path("plan.json"), "--out", path(folder)});
    ASSERT_EQ(cut.code, 0) << cut.errors;
    const Outcome check = call({"check", path(folder + "/scene.json")});
    EXPECT_EQ(check.code, 0) << check.errors;
    const Outcome run = call({"run", path("plan.json"), "--out", path(folder + "/run"), "--quiet"});
    EXPECT_EQ(run.code, 0) << run.errors;
  }
}

}  // namespace
}  // namespace dda
