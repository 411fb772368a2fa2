// Spacings that spread so wide that drawing again what is not above 0 leaves another mean than was asked for.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstdlib>
#include <random>
#include <string>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

struct Spacing {
  std::string distribution;
  double mean, deviation;
};

std::string said_of(const Spacing& spacing) {
  return refusal(fmt::format(
      R"({{"dda": 1, "materials": {{"rock": {{"density": 2600, "young": "20 GPa", "poisson": 0.25}}}},
 "joints": {{"default": {{"friction_angle": "35 deg"}}}}, "fixed": ["rock"], "blocks": {{"rock": {{
 "boundary": [[0, 0], [10, 0], [10, 10], [0, 10]], "joint_sets": [{{"joint": "default", "dip": 0,
 "spacing": {{"mean": {}, "deviation": {}, "distribution": "{}"}}}}]}}}}, "steps": {{"dt": "1 ms", "duration": "1 s"}}}})",
      spacing.mean, spacing.deviation, spacing.distribution));
}

double draw(const Spacing& spacing, std::mt19937& random) {
  if (spacing.distribution == "normal") return std::normal_distribution(spacing.mean, spacing.deviation)(random);
  return std::uniform_real_distribution(spacing.mean - spacing.deviation, spacing.mean + spacing.deviation)(random);
}

// By drawing, with the standard library's generators.
double drawn_mean(const Spacing& spacing, std::mt19937& random) {
  constexpr int draws = 100000;
  double sum = 0;
  for (int kept = 0; kept < draws;) {
    const double value = draw(spacing, random);
    if (value <= 0) continue;
    sum += value;
    ++kept;
  }
  return sum / draws;
}

TEST(WideSpread, IsRefusedWithTheMeanThatWouldBeDrawn) {
  std::mt19937 random(4);
  for (int i = 0; i < 12; ++i) {
    const double mean = std::uniform_real_distribution(1.0, 5.0)(random);
    const double deviation = mean * std::uniform_real_distribution(1.1, 12.0)(random);
    const Spacing spacing{i % 2 == 0 ? "normal" : "uniform", mean, deviation};
    const std::string sentence = said_of(spacing);
    const std::string before = "so that the mean would be ";
    ASSERT_NE(sentence.find("spacing.deviation is "), std::string::npos) << sentence;
    ASSERT_NE(sentence.find(before), std::string::npos) << sentence;
    const double told = std::strtod(sentence.c_str() + sentence.find(before) + before.size(), nullptr);
    EXPECT_NEAR(told, drawn_mean(spacing, random), 0.015 * told) << sentence;
  }
}

TEST(WideSpread, IsDrawnWhereItHasItsMean) {
  EXPECT_EQ(said_of({"normal", 3, 3}), "");
  EXPECT_EQ(said_of({"uniform", 3, 3}), "");
  EXPECT_EQ(said_of({"lognormal", 3, 9}), "");
}

}  // namespace
}  // namespace dda
