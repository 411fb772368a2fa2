// Rock that is let go slowly is let go slowly from the first step on: what its contacts carried is neither lost nor
// grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/scene/scene.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

using nlohmann::json;

// A drift in two joint sets, whose arch and wall meet blocks in corners that point inwards.
Model drift_by_lot(int seed, json joint) {
  joint["friction_angle"] = "35 deg";
  const auto set = [&](double dip) {
    return json{{"dip", {{"mean", dip + 0.1 * seed}, {"deviation", 0.05}}}, {"spacing", 1.2}, {"joint", "default"}};
  };
  const json opening = {{"name", "drift"}, {"arch", {{"foot", {0.1 * seed, -2.5}}, {"width", 5}, {"height", 5}}}};
  const json rock = {{"boundary", {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}},
                     {"joint_sets", {set(-0.5), set(0.9)}},
                     {"openings", {opening}},
                     {"merge", {{"area", 0.05}, {"angle", "5 deg"}}},
                     {"seed", seed}};
  const json scene = {
      {"dda", 1},
      {"plane", "strain"},
      {"materials", {{"rock", {{"density", 2700}, {"young", 50e9}, {"poisson", 0.25}}}}},
      {"joints", {{"default", joint}}},
      {"blocks", {{"rock", rock}}},
      {"stress_field", {{"xx", "-30 MPa"}, {"yy", "-40 MPa"}}},
      {"supports", {{{"edge", "outside"}, {"hold", "normal"}, {"until_stage", "in situ"}}}},
      {"steps",
       {{{"name", "in situ"}, {"integrator", "static"}},
        {{"name", "slowly"}, {"remove", {{"blocks", {"drift"}}, {"over", "1 s"}}}, {"dt", 5e-5}, {"duration", 1}}}}};
  return parse_scene(scene.dump(), "scene.json");
}

// Within three steps of 50 us of the second in which the rock is let go, a wall under p = 40 MPa loses 6 kPa and moves
// at that over density times wave speed, 4.7e-4 m/s. It was up to 3.4 m/s, and 0.3 on springs of 10 E: contacts are
// looked for again where the blocks are when the rock goes, and what that changed of their forces was nobody's; and a
// corner whose spring goes by the length of its face turned its depth into twenty times its force when it went over to
// a longer one.
TEST(SlowRemoval, BeginsAtRest) {
  for (const json& joint : {json::object(), json{{"normal_stiffness", "auto"}}, json{{"normal_stiffness", 1e12}},
                            json{{"spring_over_young", 10}}})
    for (int seed = 1; seed <= 10; ++seed) {
      Simulation simulation(drift_by_lot(seed, joint));
      while (stages_done(simulation) == 0) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      double fastest = 0;
      for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        for (const Vec6& velocity : simulation.state().velocity) fastest = std::max(fastest, velocity.head<2>().norm());
      }
      EXPECT_LT(fastest, 1e-3) << joint << ", seed " << seed;
    }
}

}  // namespace
}  // namespace dda
