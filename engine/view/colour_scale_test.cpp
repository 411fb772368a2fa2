#include "engine/view/colour_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace dda {
namespace {

void expect_range(const ColourScale& scale, double low, double high) {
  EXPECT_EQ(scale.low, low);
  EXPECT_EQ(scale.high, high);
}

TEST(ColourScale, BeginsAtZeroWhereThatIsNear) {
  expect_range(scale_of({1, 2, 5}), 0, 5);
  expect_range(scale_of({-5, -1}), -5, 0);
  expect_range(scale_of({90, 100}), 90, 100);
  expect_range(scale_of({-100, -90}), -100, -90);
}

TEST(ColourScale, OfBothSignsIsSymmetric) {
  const ColourScale scale = scale_of({-2, 5});
  expect_range(scale, -5, 5);
  EXPECT_TRUE(scale.diverging);
  EXPECT_EQ(scale.colour(0), diverging_map()[128]);
  EXPECT_EQ(scale.colour(5), diverging_map()[255]);
  EXPECT_EQ(scale.colour(-5), diverging_map()[0]);
}

// A little tension in a wall under compression does not turn the map around.
TEST(ColourScale, OfAlmostOneSignIsSequential) {
  const ColourScale scale = scale_of({-100, -50, 2});
  EXPECT_FALSE(scale.diverging);
  expect_range(scale, -100, 0);
  EXPECT_EQ(scale.colour(2), scale.colour(0));
}

TEST(ColourScale, ZeroIsLightAndTheFarEndDark) {
  EXPECT_EQ(scale_of({0, 5}).colour(0), sequential_map().front());
  EXPECT_EQ(scale_of({0, 5}).colour(5), sequential_map().back());
  EXPECT_EQ(scale_of({-5, 0}).colour(0), sequential_map().front());
  EXPECT_EQ(scale_of({-5, 0}).colour(-5), sequential_map().back());
  EXPECT_EQ(scale_of({-5, 0}).colour(std::nan("")), (Rgb{150, 150, 150}));
}

TEST(ColourScale, FewValuesFarAwayDoNotCount) {
  std::vector<double> values(1000);
  std::iota(values.begin(), values.end(), 1.0);
  values[0] = 1e6;
  const ColourScale scale = scale_of(values);
  EXPECT_EQ(scale.low, 0);
  EXPECT_NEAR(scale.high, 980, 1);
  EXPECT_EQ(scale.least, 2);
  EXPECT_EQ(scale.most, 1e6);
  values[0] = 1200;  // not far
  EXPECT_EQ(scale_of(values).high, 1200);
}

TEST(ColourScale, OfNothingOrOneValueIsARange) {
  for (const auto& values : std::vector<std::vector<double>>{{}, {0, 0}, {3, 3}, {-3, -3}, {std::nan(""), 2}}) {
    const ColourScale scale = scale_of(values);
    EXPECT_LT(scale.low, scale.high);
  }
}

TEST(ScaledUnit, HasAPrefixForItsSize) {
  const auto expect = [](std::string_view unit, double magnitude, double factor, const std::string& name) {
    EXPECT_EQ(scaled_unit(unit, magnitude).factor, factor) << magnitude;
    EXPECT_EQ(scaled_unit(unit, magnitude).name, name) << magnitude;
  };
  expect("Pa", 2.5e6, 1e6, "MPa");
  expect("Pa", -999, 1, "Pa");
  expect("Pa", 1e3, 1e3, "kPa");
  expect("m", 0.002, 1e-3, "mm");
  expect("m", 3e-6, 1e-6, "\u00b5m");
  expect("m", 5e4, 1, "m");
  expect("m/s", 5e4, 1, "m/s");
  expect("m", 0, 1, "m");
}

TEST(Ticks, AreRoundAndWithinTheRange) {
  EXPECT_EQ(ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(-88, 0, 6), (std::vector<double>{-80, -60, -40, -20, 0}));
  EXPECT_EQ(ticks(0.3, 0.3, 5), std::vector<double>{0.3});
  const auto small = ticks(0, 3.1e-4, 6);
  ASSERT_EQ(small.size(), 4U);
  EXPECT_NEAR(small[3], 3e-4, 1e-18);
}

TEST(Label, HasTheDigitsOfItsStep) {
  EXPECT_EQ(label(-80, 20), "\u221280");
  EXPECT_EQ(label(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(label(1, 0.25), "1.0");
  EXPECT_EQ(label(-1e-12, 0.5), "0.0");
  EXPECT_EQ(label(0.0002, 0.0001), "0.0002");
}

}  // namespace
}  // namespace dda
