// Angles of scenes that lost their unit: degrees taken for radians give joints in another direction, without a word.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

using Written = std::function<std::string(const std::string&)>;  // a scene with this angle in it

std::string with_rock(const std::string& rock) {
  return R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "35 deg"}}, "fixed": ["rock"], "blocks": )" +
         rock + R"(, "steps": {"dt": "1 ms", "duration": "1 s"}})";
}

std::string with_set(const std::string& dip) {
  return with_rock(
      R"({"rock": {"boundary": [[0, 0], [10, 0], [10, 10], [0, 10]], "joint_sets": [{"joint": "default", "spacing": "6 m", "dip": )" +
      dip + "}]}}");
}

std::string with_turn(const std::string& angle) {
  std::string scene = with_rock(R"([{"polygon": {"name": "rock", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}}])");
  const std::string fixed = R"("fixed": ["rock"])";
  return scene.replace(
      scene.find(fixed), fixed.size(),
      R"("supports": [{"block": "rock", "history": {"table": [[0, 0], [1, 1]]}, "rotation": )" + angle + "}]");
}

const std::vector<Written> directions = {
    with_set, [](const std::string& angle) { return with_set(R"({"deviation": 0.1, "mean": )" + angle + "}"); },
    [](const std::string& angle) { return with_set(R"({"mean": 0.1, "deviation": )" + angle + "}"); },
    [](const std::string& angle) {
      return with_set(R"({"distribution": "fisher", "concentration": 50, "mean": )" + angle + "}");
    },
    [](const std::string& angle) {
      return with_rock(R"([{"rings": {"name": "rock", "radii": [1, 2], "sectors": 8, "first_corner": )" + angle +
                       "}}]");
    }};

void expect_hint(const std::string& scene) {
  EXPECT_NE(refusal(scene).find("without a unit it is in radians, for degrees write"), std::string::npos) << scene;
}

// Whole degrees by lot, but for the few that are an angle in radians too.
std::vector<int> degrees_by_lot() {
  std::mt19937 random(20);
  std::vector<int> angles;
  for (int i = 0; i < 12; ++i) angles.push_back(std::uniform_int_distribution(7, 359)(random));
  return angles;
}

TEST(AngleWithoutUnit, DegreesAreNotTakenForRadians) {
  for (const int degrees : degrees_by_lot())
    for (const Written& scene : directions) {
      expect_hint(scene(fmt::format("{}", degrees)));
      EXPECT_EQ(refusal(scene(fmt::format("\"{} deg\"", degrees))), "");
      EXPECT_EQ(refusal(scene(fmt::format("{:.17g}", degrees * std::numbers::pi / 180))), "");
    }
}

TEST(AngleWithoutUnit, DirectionsAreWithinAFullTurn) {
  for (const Written& scene : directions) {
    EXPECT_EQ(refusal(scene("\"360 deg\"")), "");
    EXPECT_NE(refusal(scene("\"400 deg\"")).find("expected an angle of at most a full turn"), std::string::npos);
    EXPECT_NE(refusal(scene("1e300")), "");
  }
}

TEST(AngleWithoutUnit, BlocksTurnAsOftenAsIsSaid) {
  for (const int degrees : degrees_by_lot()) {
    expect_hint(with_turn(fmt::format("{}", degrees)));
    EXPECT_EQ(refusal(with_turn(fmt::format("\"{} deg\"", 10 * degrees))), "");
  }
}

TEST(AngleWithoutUnit, CornersToMergeAreSharp) {
  const auto merging = [](const std::string& angle) {
    return with_rock(
        R"({"rock": {"boundary": [[0, 0], [10, 0], [10, 10], [0, 10]], "lines": [{"joint": "default", "points": [[0, 0], [10, 10]]}], "merge": {"angle": )" +
        angle + "}}}");
  };
  for (const int degrees : degrees_by_lot()) expect_hint(merging(fmt::format("{}", degrees)));
  EXPECT_EQ(refusal(merging("\"8 deg\"")), "");
}

TEST(AngleWithoutUnit, StrengthToJudgeByIsAnAngleOfFriction) {
  const auto judging = [](const std::string& angle) {
    std::string scene = with_set("0");
    const std::string before = R"("steps")";
    return scene.replace(
        scene.find(before), before.size(),
        R"("measurements": [{"quantity": "excess_shear", "friction_angle": )" + angle + R"(}], "steps")");
  };
  expect_hint(judging("30"));
  EXPECT_EQ(refusal(judging("\"30 deg\"")), "");
}

}  // namespace
}  // namespace dda
