#include "engine/view/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dda {
namespace {

// Values of OKLab as its author publishes them for the corners of sRGB (three digits).
TEST(Oklab, OfKnownColours) {
  const auto expect = [](const Rgb& colour, const Vec3& expected) {
    EXPECT_LE((oklab(colour) - expected).lpNorm<Eigen::Infinity>(), 6e-4) << to_hex(colour);
  };
  expect({255, 255, 255}, Vec3(1, 0, 0));
  expect({0, 0, 0}, Vec3(0, 0, 0));
  expect({255, 0, 0}, Vec3(0.628, 0.225, 0.126));
  expect({0, 255, 0}, Vec3(0.866, -0.234, 0.179));
  expect({0, 0, 255}, Vec3(0.452, -0.032, -0.312));
}

TEST(Oklab, HexOfAColour) { EXPECT_EQ(to_hex({255, 1, 160}), "#ff01a0"); }

// How different colours look that are `step` values apart, all along a map.
std::vector<double> differences(const ColourMap& map, std::size_t step) {
  std::vector<double> found;
  for (std::size_t i = 0; i + step < map.size(); i += step)
    found.push_back((oklab(map[i + step]) - oklab(map[i])).norm());
  return found;
}

// Steps of 15 values are 0.05 to 0.08 long; rounding to 8 bits moves a colour by up to 0.002, and where the line
// through the colours bends a chord is shorter than its arc by up to a tenth.
TEST(ColourMaps, EqualStepsLookEqual) {
  for (const ColourMap* map : {&sequential_map(), &diverging_map()}) {
    auto steps = differences(*map, 15);
    // Across the middle of the diverging map lightness goes up and down again: its two arms are judged by themselves.
    if (map == &diverging_map()) steps.erase(steps.begin() + 8);
    double mean = 0;
    for (const double step : steps) mean += step / static_cast<double>(steps.size());
    EXPECT_GT(mean, 0.04);  // the eye tells colours apart from 0.02 on
    for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_NEAR(steps[i], mean, 0.12 * mean) << i;
  }
}

// That of lines is shorter, as its colours must stand out from those of blocks on either side: a step of 15 values can
// just be told apart.
TEST(ColourMaps, UtilisationGoesFromGreenToOrange) {
  const auto steps = differences(utilisation_map(), 15);
  double mean = 0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  EXPECT_GT(mean, 0.02);
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_NEAR(steps[i], mean, 0.2 * mean) << i;
  EXPECT_EQ(to_hex(utilisation_map().front()), "#007a3d") << "as bolts";
  EXPECT_EQ(to_hex(utilisation_map().back()), "#f08a00") << "as what has yielded";
}

TEST(ColourMaps, SequentialOneDarkensAllTheWay) {
  double before = 1;
  for (std::size_t i = 0; i < 256; i += 5) {
    const double lightness = oklab(sequential_map()[i])(0);
    EXPECT_LT(lightness, before) << i;
    before = lightness;
  }
  EXPECT_GT(oklab(sequential_map().front())(0), 0.95);
  EXPECT_LT(oklab(sequential_map().back())(0), 0.35);
}

TEST(ColourMaps, DivergingOneIsBlueAndRedAroundALightMiddle) {
  const ColourMap& map = diverging_map();
  const Vec3 cold = oklab(map.front());
  const Vec3 warm = oklab(map.back());
  EXPECT_LT(cold(2), -0.05);  // blue
  EXPECT_GT(warm(1), 0.05);   // red
  EXPECT_NEAR(cold(0), warm(0), 0.06);
  EXPECT_GT(oklab(map[127])(0), 0.95);
  for (std::size_t i = 0; i < 120; i += 5) {
    EXPECT_LT(oklab(map[i])(0), oklab(map[i + 5])(0)) << i;
    EXPECT_LT(oklab(map[255 - i])(0), oklab(map[250 - i])(0)) << i;
  }
}

}  // namespace
}  // namespace dda
