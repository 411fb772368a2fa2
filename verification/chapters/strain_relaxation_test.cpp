#include "verification/chapters/strain_relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "engine/core/temporary_folder.h"
#include "verification/chapters/chapters_test_support.h"

namespace verify {
namespace {

std::optional<bool> verdict(const std::vector<RelaxationResult>& results, const std::string& id) {
  Chapter chapter;
  judge_relaxation(results, chapter);
  return verdict(chapter, id);
}

// As the thesis describes it.
std::vector<RelaxationResult> as_described() {
  RelaxationResult result;
  result.reading.name = "described";
  for (const double stress : relaxation_stresses()) {
    const double share = stress / 50e6;
    result.outcomes.push_back({stress, 0.01 + share, 1 + 100 * share, 0.001 + share, stress > 0 ? 1.0 : 0.0,
                               stress > 0 ? 0.0 : 1.0, 1, 1e5 + stress, 1e4 + stress / 10});
  }
  return {result};
}

TEST(StrainRelaxation, WhatTheThesisDescribesIsConfirmed) {
  for (const char* id :
       {"6.1-block-1-stays", "6.1-block-2-falls", "6.1-block-2-stays", "6.1-velocity-rises", "6.1-acceleration-rises",
        "6.1-displacement-rises", "6.1-velocity-linear", "6.1-acceleration-linear", "6.1-threshold",
        "6.1-wall-above-far", "6.1-wall-response-rises", "6.1-far-response-rises"})
    EXPECT_EQ(verdict(as_described(), id), true) << id;
}

TEST(StrainRelaxation, WhatIsOtherwiseIsNot) {
  std::vector<RelaxationResult> results = as_described();
  std::vector<RelaxationOutcome>& outcomes = results.front().outcomes;
  outcomes[0].wall_end_speed = 0.6;
  outcomes[0].roof_end_speed = 0.4;
  outcomes[3].roof_end_speed = 0.6;
  outcomes[2].near_response = outcomes[2].far_response;
  for (RelaxationOutcome& o : outcomes) o.wall_peak_velocity = std::sqrt(o.stress);
  for (const char* id : {"6.1-block-1-stays", "6.1-block-2-falls", "6.1-block-2-stays", "6.1-velocity-linear",
                         "6.1-threshold", "6.1-wall-above-far", "6.1-wall-response-rises"})
    EXPECT_EQ(verdict(results, id), false) << id;
  EXPECT_EQ(verdict(results, "6.1-velocity-rises"), true);
}

TEST(StrainRelaxation, AReadingWithAFailedRunTellsNothing) {
  std::vector<RelaxationResult> results = as_described();
  results.front().missing = "30 MPa: not_converged";
  EXPECT_EQ(verdict(results, "6.1-velocity-rises"), std::nullopt);
}

// Block 1 oscillates and stops, block 2 falls freely; the first row is before settling.
SceneRun example_run() {
  std::ostringstream csv;
  csv << "time [s]";
  for (const char* block : {"block_1", "block_2"})
    for (const char* q : {"displacement_x [m]", "displacement_y [m]", "velocity_x [m/s]", "velocity_y [m/s]",
                          "acceleration_x [m/s2]", "acceleration_y [m/s2]"})
      csv << "," << block << "_" << q;
  csv << ",point_3_xx [Pa],point_3_yy [Pa],point_5_xx [Pa],point_5_yy [Pa]\n";
  csv << "0,0,0,9,9,9,9,0,0,0,0,0,0,0,0,0,0\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = 1e-3 * i;
    const double fallen = -9.81 * t * t / 2;
    csv << t << "," << (i > 50 ? 0.002 : 0.001) << ",-0.5," << (i == 3 ? 0.3 : 0) << "," << (i == 3 ? 0.4 : 0) << ",0,"
        << (i == 0 ? -70 : 0) << ",0," << fallen - 0.5 << ",0,0,0,0," << (i == 9 ? -3e6 : -1e6) << ",0,"
        << "-1e6," << (i == 20 ? 5e5 : 0) << "\n";
  }
  return run_that_left(csv.str());
}

TEST(StrainRelaxation, ReadsWhatHappensAfterTheTunnelIsOpened) {
  RelaxationReading reading;
  reading.dt = 1e-3;
  reading.duration = 0.1;
  const RelaxationOutcome o = relaxation_outcome(reading, 10e6, example_run());
  EXPECT_NEAR(o.wall_peak_velocity, 0.5, 1e-12);
  EXPECT_NEAR(o.wall_peak_acceleration, 70, 1e-12);
  EXPECT_NEAR(o.wall_displacement, 0.001, 1e-12);
  EXPECT_EQ(o.wall_end_speed, 0);
  EXPECT_NEAR(o.roof_end_speed, 9.81 * 0.09, 1e-3);
  EXPECT_NEAR(o.free_fall_speed, 9.81 * 0.09, 9.81e-3);
  EXPECT_NEAR(o.near_response, 2e6, 1e-3);
  EXPECT_NEAR(o.far_response, 5e5, 1e-3);
}

// With k01 = 0.99 the speed of a falling block tends to g dt k/(1 - k).
TEST(StrainRelaxation, FreeFallKnowsKineticDamping) {
  RelaxationReading reading;
  reading.dt = 1e-4;
  reading.duration = 0.5;
  reading.velocity_factor = 0.99;
  EXPECT_NEAR(relaxation_outcome(reading, 0, example_run()).free_fall_speed, 9.81e-4 * 0.99 / 0.01, 1e-9);
}

TEST(StrainRelaxation, FindsTheLargestKeyBlocksOfWallAndRoof) {
  const auto body = [](const char* name, const char* type, double area, double x, double y) {
    return SceneFolder::Scene{{"blocks", {name}}, {"type", type}, {"area", area}, {"centroid", {x, y}}};
  };
  const SceneFolder::Scene bodies = {body("a", "II", 1, -5, 0), body("b", "II", 2, -5, 1), body("c", "II", 3, 5, 0),
                                     body("d", "I", 1, 0, 5),   body("e", "III", 9, 0, 5), body("f", "I", 9, 0, -5)};
  EXPECT_EQ(key_blocks_of(bodies).wall, "b");
  EXPECT_EQ(key_blocks_of(bodies).roof, "d");
  EXPECT_EQ(key_blocks_of(SceneFolder::Scene::array()).wall, "");
}

TEST(SceneFolder, KeepsTheRunOfTheSameSceneAlone) {
  const dda::TemporaryFolder folder;
  std::ostringstream out;
  const SceneFolder scenes(folder.path(), "dda", 1, out);
  const auto result = folder.path() / "runs" / "a";
  scenes.put("a", {{"dda", 1}});
  std::filesystem::create_directories(result);
  std::ofstream(result / "summary.json") << R"({"status": "not_converged", "message": "why"})";
  scenes.put("a", {{"dda", 1}});
  EXPECT_EQ(scenes.read("a").status, "not_converged");
  EXPECT_EQ(scenes.read("a").message, "why");
  scenes.put("a", {{"dda", 1}, {"gravity", 9.81}});
  EXPECT_EQ(scenes.read("a").status, "missing");
}

}  // namespace
}  // namespace verify
