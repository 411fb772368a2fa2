#include "engine/builder/generators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/builder/builder_models.h"
#include "engine/core/error.h"

namespace dda {
namespace {

double total_area(const Model& model) {
  double area = 0;
  for (const Block& block : model.blocks) area += block.moments.area;
  return area;
}

TEST(Bar, CoversItsLengthWithBlocksThatShareCorners) {
  for (const double block_length : {0.1, 0.3, 0.5, 7.0 / 3}) {
    Model model = with_rock();
    EXPECT_EQ(append_bar(model, {.origin = {0.1, -1}, .length = 21, .height = 1, .block_length = block_length}), 0);
    ASSERT_EQ(model.blocks.size(), static_cast<std::size_t>(std::lround(21 / block_length)));
    for (std::size_t i = 1; i < model.blocks.size(); ++i) {
      EXPECT_EQ(model.blocks[i].shape.outer[0], model.blocks[i - 1].shape.outer[1]);
      EXPECT_EQ(model.blocks[i].shape.outer[3], model.blocks[i - 1].shape.outer[2]);
    }
    EXPECT_EQ(model.blocks.front().shape.outer[0], Vec2(0.1, -1));
    EXPECT_EQ(model.blocks.back().shape.outer[2], Vec2(0.1 + 21, 0));
    finish_model(model);  // no overlaps
  }
}

TEST(Bar, GivesItsBlocksNamesAndState) {
  Model model = with_rock();
  BarSpec spec{.length = 2, .height = 1, .block_length = 1};
  spec.group = {"rod", 0, Vec3(1, 2, 3), Vec2(4, 5), 6};
  append_bar(model, spec);
  EXPECT_EQ(append_bar(model, {.origin = {0, 2}, .length = 1, .height = 1, .block_length = 1}), 2);
  EXPECT_EQ(model.blocks[0].name, "rod 1");
  EXPECT_EQ(model.blocks[1].name, "rod 2");
  EXPECT_EQ(model.blocks[2].name, "bar 1");
  EXPECT_EQ(model.blocks[1].initial_stress, Vec3(1, 2, 3));
  EXPECT_EQ(model.blocks[1].initial_velocity, Vec2(4, 5));
  EXPECT_EQ(model.blocks[1].initial_spin, 6);
}

TEST(Bar, RefusesAFractionOfABlockAndSizesOfNone) {
  Model model = with_rock();
  EXPECT_THROW(append_bar(model, {.length = 10, .height = 1, .block_length = 3}), InputError);
  EXPECT_THROW(append_bar(model, {.length = 10, .height = 1, .block_length = 0}), InputError);
  EXPECT_THROW(append_bar(model, {.length = 10, .height = -1, .block_length = 1}), InputError);
  EXPECT_THROW(append_bar(model, {.length = std::numeric_limits<double>::quiet_NaN(), .height = 1, .block_length = 1}),
               InputError);
  EXPECT_TRUE(model.blocks.empty());
}

TEST(Grid, StacksRowsFromBelow) {
  Model model = with_rock();
  append_grid(model, {.origin = {1, 2}, .columns = 3, .rows = 2, .block_width = 0.5, .block_height = 0.25});
  ASSERT_EQ(model.blocks.size(), 6U);
  EXPECT_EQ(model.blocks[0].name, "grid 1.1");
  EXPECT_EQ(model.blocks[4].name, "grid 2.2");
  EXPECT_EQ(model.blocks[4].shape.outer[0], Vec2(1.5, 2.25));
  EXPECT_EQ(model.blocks[4].shape.outer[2], Vec2(2, 2.5));
  finish_model(model);
  EXPECT_DOUBLE_EQ(total_area(model), 6 * 0.125);
}

TEST(Grid, RunningBondHasHalfBlocksAtTheEndsOfEverySecondRow) {
  Model model = with_rock();
  append_grid(model,
              {.columns = 2, .rows = 3, .block_width = 1, .block_height = 1, .pattern = GridPattern::running_bond});
  ASSERT_EQ(model.blocks.size(), 2U + 3U + 2U);
  EXPECT_EQ(model.blocks[2].shape.outer[2], Vec2(0.5, 2));
  EXPECT_EQ(model.blocks[3].shape.outer[0], Vec2(0.5, 1));
  EXPECT_EQ(model.blocks[4].shape.outer[0], Vec2(1.5, 1));
  EXPECT_EQ(model.blocks[4].shape.outer[1], Vec2(2, 1));
  finish_model(model);
  EXPECT_DOUBLE_EQ(total_area(model), 6);
}

TEST(Grid, RefusesNoColumnsAndBlocksBeyondCounting) {
  Model model = with_rock();
  EXPECT_THROW(append_grid(model, {.columns = 0, .rows = 1, .block_width = 1, .block_height = 1}), InputError);
  EXPECT_THROW(append_grid(model, {.columns = 100000, .rows = 100000, .block_width = 1, .block_height = 1}),
               InputError);
}

TEST(Rings, AreOctagonsAroundAnOpening) {
  Model model = with_rock();
  const double eighth = std::numbers::pi / 4;
  EXPECT_EQ(append_rings(model, {.centre = {3, -1}, .radii = {1, 2, 2.5}, .sectors = 8, .first_corner = eighth / 2}),
            0);
  ASSERT_EQ(model.blocks.size(), 16U);
  EXPECT_EQ(model.blocks[7].name, "rings 1.8");
  EXPECT_EQ(model.blocks[8].name, "rings 2.1");
  EXPECT_EQ(model.blocks[7].shape.outer[2], model.blocks[0].shape.outer[1]);              // the last joint is the first
  EXPECT_EQ(model.blocks[0].shape.outer[1], model.blocks[8].shape.outer[0]);              // rings share corners
  EXPECT_NEAR(model.blocks[1].shape.outer[1].y(), -1 + 2 * std::cos(eighth / 2), 1e-15);  // a level side on top
  EXPECT_NEAR(model.blocks[1].shape.outer[2].y(), -1 + 2 * std::cos(eighth / 2), 1e-15);
  finish_model(model);
  EXPECT_NEAR(total_area(model), 4 * std::sin(eighth) * (2.5 * 2.5 - 1), 1e-13);
}

TEST(Rings, RefuseWhatIsNoRing) {
  Model model = with_rock();
  EXPECT_THROW(append_rings(model, {.radii = {1, 2}, .sectors = 2}), InputError);
  EXPECT_THROW(append_rings(model, {.radii = {1}, .sectors = 8}), InputError);
  EXPECT_THROW(append_rings(model, {.radii = {0, 1}, .sectors = 8}), InputError);
  EXPECT_THROW(append_rings(model, {.radii = {1, 1}, .sectors = 8}), InputError);
  EXPECT_THROW(append_rings(model, {.radii = {1, 2, 3}, .sectors = 1'000'000}), InputError);
  EXPECT_TRUE(model.blocks.empty());
}

}  // namespace
}  // namespace dda
