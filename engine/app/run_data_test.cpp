// dda cut with blocks of dc and run data of df: scenes that run as the numbers of the files ask for.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// A floor that is held at two points, and a stone at rest a metre above it with a point to measure.
const std::string stone_in_the_air =
    "2 0 16\n2 0 1\n1 1 4\n1 9 12\n"
    "1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 4 0\n0 8 2\n0 0 0\n"
    "1 1 2\n1 2 2\n1 2 3\n1 1 3\n1 1 2\n0 1 0\n0 1.5 2.5\n0 0 0\n"
    "0.5 0.5 1\n3.5 0.5 1\n1.5 2.5 2\n";
const std::string material = "2500 25000 1e9 0.2\n0 0 0\n0 0 0\n0 0 0\n";
const std::string joint = "30 0 0\n";

class RunDataOfDf : public CommandLine {
 protected:
  nlohmann::json cut(const std::string& blocks, const std::string& data) {
    write("a.blck", blocks);
    write("a.df", data);
    const Outcome cut = call({"cut", path("a.blck"), "--run-data", path("a.df"), "--out", path("out")});
    EXPECT_EQ(cut.code, 0) << cut.errors;
    return nlohmann::json::parse(text("out/scene.json"));
  }

  // The last row of the histories of a run of out/scene.json.
  std::vector<double> last_row() {
    const Outcome run = call({"run", path("out/scene.json"), "--out", path("results"), "--quiet"});
    EXPECT_EQ(run.code, 0) << run.errors;
    std::string rows = text("results/histories.csv");
    rows.pop_back();
    std::vector<double> values;
    std::istringstream row(rows.substr(rows.rfind('\n') + 1));
    for (std::string value; std::getline(row, value, ',');) values.push_back(std::stod(value));
    return values;
  }
};

// Weight over density is the gravity of the file, 10 m/s2. Ten steps of 10 ms, as the displacements allow longer ones.
TEST_F(RunDataOfDf, AStoneFalls) {
  const nlohmann::json scene = cut(stone_in_the_air, "1 10 1 1 0.1 0.01\n" + material + joint);
  EXPECT_EQ(scene["gravity"], nlohmann::json({0, -10}));
  EXPECT_EQ(scene["supports"].size(), 2U);
  EXPECT_EQ(scene["supports"][0]["block"], "rock 1");
  EXPECT_EQ(scene["steps"][0]["dt"], 0.01);
  const std::vector<double> row = last_row();
  EXPECT_NEAR(row[0], 0.1, 1e-12);
  EXPECT_NEAR(row[2], -10 * 0.1 * 0.1 / 2, 1e-12);
}

// Without a longest step: half the height is 1.5 m, so a step is the time of a fall of 0.003 x 1.5 m.
TEST_F(RunDataOfDf, StepsAreAsLongAsDisplacementsAllow) {
  const nlohmann::json scene = cut(stone_in_the_air, "1 10 1 1 0.003 0\n" + material + joint);
  EXPECT_NEAR(scene["steps"][0]["dt"].get<double>(), std::sqrt(2 * 0.003 * 1.5 / 10), 1e-15);
  EXPECT_NEAR(scene["steps"][0]["duration"].get<double>(), 10 * std::sqrt(2 * 0.003 * 1.5 / 10), 1e-14);
  EXPECT_FALSE(scene["steps"][0].contains("integrator"));
  const nlohmann::json still = cut(stone_in_the_air, "0 10 1 1 0.003 0\n" + material + joint);
  EXPECT_EQ(still["steps"][0]["integrator"], "static");
}

// A velocity at the start and a spin, without weight: both go on.
TEST_F(RunDataOfDf, BlocksBeginWithTheVelocitiesAndStressesOfTheirMaterial) {
  std::string blocks = stone_in_the_air;
  blocks.replace(blocks.find("1 9 12"), 6, "2 9 12");
  const std::string still = "2500 0 1e9 0.2\n0 0 0\n0 0 0\n0 0 0\n";
  const nlohmann::json scene =
      cut(blocks, "1 10 2 1 0.1 0.01\n" + still + "2500 0 1e9 0.2\n0 0 0\n0 0 0\n0.3 0.4 0\n" + joint);
  ASSERT_EQ(scene["blocks"].size(), 2U);
  EXPECT_FALSE(scene["blocks"][0]["polygon"].contains("initial_velocity"));
  EXPECT_EQ(scene["blocks"][1]["polygon"]["material"], "material 2");
  const std::vector<double> row = last_row();
  EXPECT_NEAR(row[1], 0.03, 1e-12);
  EXPECT_NEAR(row[2], 0.04, 1e-12);
  const nlohmann::json pressed =
      cut(stone_in_the_air, "1 10 1 1 0.1 0.01\n2500 0 1e9 0.2\n-1 -2 0.5\n0 0 0\n0 0 0\n" + joint);
  EXPECT_EQ(pressed["blocks"][0]["polygon"]["initial_stress"],
            nlohmann::json({{"xx", -1.0}, {"yy", -2.0}, {"xy", 0.5}}));
}

// A force of 2500 N that grows from 0 in 0.1 s on 2500 kg: a t^3/(6 T) with a = 1 m/s2. Steps take the force of their
// end, which makes the displacement larger by 3/(2 n) and 1/(2 n^2) in n steps.
TEST_F(RunDataOfDf, LoadPointsFollowTheirTables) {
  std::string blocks = stone_in_the_air;
  blocks.replace(blocks.find("2 0 1\n"), 6, "2 1 1\n");
  blocks.replace(blocks.find("1.5 2.5 2\n"), 10, "1.5 2.5 2\n1.5 2.5 2\n");
  const std::string weightless = "2500 0 1e9 0.2\n0 0 0\n0 0 0\n0 0 0\n";
  const nlohmann::json scene = cut(blocks, "1 100 1 1 0.5 0.001\n1e8\n0 0 2\n0 0 0\n0.1 2500 0\n" + weightless + joint);
  ASSERT_EQ(scene["loads"].size(), 1U);
  EXPECT_EQ(scene["loads"][0]["block"], "rock 2");
  EXPECT_EQ(scene["joints"]["default"]["normal_spring"], 1e8);
  const double exact = 1 * 0.1 * 0.1 / 6;
  EXPECT_NEAR(last_row()[1], exact * (1 + 1.5 / 100 + 0.5 / 1e4), 1e-12);
}

// The first fixed point goes up by 2 mm, then stays: so does the floor, and turns.
TEST_F(RunDataOfDf, FixedPointsMoveByTheirTables) {
  const nlohmann::json scene =
      cut(stone_in_the_air, "1 10 1 1 0.1 0.01\n0\n2 0\n0 0 0\n1 0 0.002\n" + material + joint);
  ASSERT_EQ(scene["supports"].size(), 3U);
  EXPECT_EQ(scene["supports"][0]["hold"], "x");
  EXPECT_FALSE(scene["supports"][0].contains("displacement"));
  EXPECT_EQ(scene["supports"][1]["hold"], "y");
  EXPECT_EQ(scene["supports"][1]["displacement"], nlohmann::json({0, 1}));
  EXPECT_EQ(scene["supports"][1]["history"]["table"][1], nlohmann::json({1.0, 0.002}));
  EXPECT_FALSE(scene["supports"][2].contains("hold"));
}

// Lines of dc: their joint materials are those of the data.
TEST_F(RunDataOfDf, LinesOfDcHaveTheJointsOfTheData) {
  write("a.dc", "0.001\n5 0\n0\n0\n1\n0\n0\n0\n0 0 4 0 1\n4 0 4 4 1\n4 4 0 4 1\n0 4 0 0 1\n-0.5 2 4.5 2 2\n1 1 1 1\n");
  write("a.df", "1 10 1 2 0.1 0.01\n" + material + joint + "20 100 0\n");
  const Outcome cut = call({"cut", path("a.dc"), "--run-data", path("a.df"), "--out", path("out")});
  ASSERT_EQ(cut.code, 0) << cut.errors;
  const auto scene = nlohmann::json::parse(text("out/scene.json"));
  EXPECT_EQ(scene["joint_lines"][0]["joint"], "joint 2");
  EXPECT_NEAR(scene["joints"]["joint 2"]["friction_angle"].get<double>(), 20 * M_PI / 180, 1e-15);
  EXPECT_EQ(scene["joints"]["joint 2"]["cohesion"], 100);
  EXPECT_EQ(scene["materials"]["material 1"]["young"], 1e9);
  EXPECT_EQ(call({"check", path("out/scene.json")}).code, 0);
}

TEST_F(RunDataOfDf, WhatDoesNotGoTogetherIsRefused) {
  write("a.blck", stone_in_the_air);
  write("a.csv", "layer,x1,y1,x2,y2\n");
  const auto refused = [this](const std::string& data, const std::string& sentence) {
    write("a.df", data);
    expect_refusal({"cut", path("a.blck"), "--run-data", path("a.df"), "--out", path("out")}, sentence);
    EXPECT_FALSE(exists("out/scene.json"));
  };
  refused("1 10 2 1 0.1 0.01\n" + material + "2500 0 1e9 0.2\n0 0 0\n0 0 0\n0 0 0\n" + joint,
          "a unit weight of 0 times the density, expected 10 times, as of the first material: a scene has one gravity");
  refused("1 10 1 1 0.1 0\n2500 0 1e9 0.2\n0 0 0\n0 0 0\n0 0 0\n" + joint, "expected a longest step above 0");
  refused("1 10 1 1 0.1 0\n" + material, "numbers for 1 block and 1 joint materials");
  write("a.blck",
        "2 0 16\n0 0 0\n1 1 4\n1 9 12\n1 0 0\n1 1 0\n3 1 1\n1 0 1\n1 0 0\n0 1 0\n0 0.5 0.5\n0 0 0\n"
        "3 0 1\n1 1 1\n1 1 2\n1 0 2\n3 0 1\n0 1 0\n0 0.5 1.5\n0 0 0\n");
  refused("1 10 1 1 0.1 0\n" + material + joint, "of the joint material 3, expected one of the 1 of");
  const std::string data = path("a.df");
  expect_refusal({"cut", path("a.csv"), "--run-data", data, "--out", path("out")},
                 "--run-data is given beside " + path("a.csv") + ", expected blocks or lines of dc");
  expect_refusal({"cut", path("a.blck"), "--run-data", data, "--unit", "mm", "--out", path("out")},
                 "--unit is given beside --run-data");
  expect_refusal({"cut", path("a.blck"), "--run-data", path("none.df"), "--out", path("out")}, "none.df is missing");
  expect_refusal({"cut", data, "--out", path("out")}, "data of a run for df");
}

}  // namespace
}  // namespace dda
