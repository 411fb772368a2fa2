// What a run says of its linings.
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

class LiningRun : public CommandLine {};

const char* const scene = R"({"dda": 1, "gravity": 9.81,
  "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.2}},
  "joints": {"default": {"friction_angle": 0}},
  "blocks": [{"polygon": {"name": "left", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
             {"polygon": {"name": "middle", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
             {"polygon": {"name": "right", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]]}}],
  "fixed": ["left", "right"],
  "linings": [{"name": "shotcrete", "along": [[0, 0], [3, 0]], "thickness": "10 cm", "young": "15 GPa",
               "compressive_strength": "20 MPa", "tensile_strength": "2 MPa"}],
  "measurements": [{"name": "shear", "quantity": "lining_shear", "lining": "shotcrete", "point": [1, 0]},
                   {"name": "moment", "quantity": "lining_moment", "lining": "shotcrete"},
                   {"name": "thrust", "quantity": "lining_thrust", "lining": "shotcrete"},
                   {"name": "cut", "quantity": "resultant", "line": {"from": [1, -1], "to": [1, 2]}}],
  "steps": {"integrator": "static", "dt": "1 s", "duration": "3 s", "equilibrium": 1e-9}})";

// A stone between two others whose joints are smooth hangs on the concrete below it.
TEST_F(LiningRun, SaysWhatAStoneHangsOn) {
  write("scene.json", scene);
  const Outcome check = call({"check", path("scene.json")});
  EXPECT_EQ(check.code, 0) << check.errors;
  EXPECT_TRUE(
      contains(check.out, "\"shotcrete\", 0.1 m thick, 2 elements, crushes at 2e+06 N and tears at 200000 N per m"))
      << check.out;
  EXPECT_TRUE(contains(check.out, "linings: beams on the wall, which can yield")) << check.out;
  const Outcome run = call({"run", path("scene.json"), "--out", path("out"), "--frames", "1", "--quiet"});
  EXPECT_EQ(run.code, 0) << run.errors;
  const auto summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "ok");
  const auto& lining = summary["linings"][0];
  EXPECT_EQ(lining["name"], "shotcrete");
  EXPECT_EQ(lining["elements"], 2);
  EXPECT_EQ(lining["sprayed"], true);
  const double half_weight = 2600 * 9.81 / 2;
  EXPECT_NEAR(std::abs(lining["shear"]["value"].get<double>()), half_weight, 1e-3 * half_weight);
  EXPECT_EQ(lining["shear"]["between"].size(), 2U);
  EXPECT_GT(lining["utilisation"]["value"], 0.0);
  EXPECT_LT(lining["utilisation"]["value"], 1.0);
  EXPECT_TRUE(lining["yielded"].empty());
  EXPECT_GT(summary["energy"]["linings"], 0.0);
  EXPECT_LT(std::abs(summary["energy"]["residual_relative"].get<double>()), 1e-9);
  EXPECT_TRUE(contains(text("out/linings.pvd"), "linings/000000.vtp"));
}

}  // namespace
}  // namespace dda
