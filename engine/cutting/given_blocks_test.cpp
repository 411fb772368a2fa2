// Blocks that are given, with joints along them.
#include "engine/cutting/given_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/core/error.h"
#include "engine/cutting/cut_rock.h"

namespace dda {
namespace {

// Squares of 1 m side by side.
RockPlan squares(int count) {
  RockPlan plan;
  for (int i = 0; i < count; ++i) {
    const double x = i;
    plan.blocks.push_back({{{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}, {}}, "wall", "", "a block"});
  }
  return plan;
}

PlanLine line(const Vec2& from, const Vec2& to) { return {{from, to}, "bed", "a line", false}; }

TEST(GivenBlocks, ComeInTheOrderOfCutOnesWhateverTheirs) {
  RockPlan plan = squares(3);
  std::swap(plan.blocks[0], plan.blocks[2]);
  std::ranges::reverse(plan.blocks[1].shape.outer);
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.blocks.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const CutBlock& block = rock.blocks[static_cast<std::size_t>(i)];
    EXPECT_EQ(block.shape.outer.front(), Vec2(i, 0));
    EXPECT_EQ(signed_area(block.shape.outer), 1);
    EXPECT_EQ(block.group, "wall");
  }
  EXPECT_EQ(rock.boundary_area, 3);
}

TEST(GivenBlocks, MaterialsAreThoseOfRegionsThenTheirOwnThenThePlans) {
  RockPlan plan = squares(3);
  plan.material = "stone";
  plan.blocks[0].material = plan.blocks[1].material = "brick";
  plan.regions.push_back({{{-1, -1}, {1, -1}, {1, 2}, {-1, 2}}, "clay", "a region"});
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks[0].material, "clay");
  EXPECT_EQ(rock.blocks[1].material, "brick");
  EXPECT_EQ(rock.blocks[2].material, "stone");
}

TEST(GivenBlocks, JointsLieWhereTwoBlocksTouch) {
  RockPlan plan = squares(3);
  plan.lines = {line({1, -2}, {1, 3}), line({3, 0}, {3, 1}), line({5, 0}, {6, 0}), line({2, 1}, {2, 1})};
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.joints.size(), 1U);  // one that sticks out is taken as it is
  EXPECT_EQ(rock.joints[0].from, Vec2(1, -2));
  ASSERT_EQ(rock.cleaned.size(), 3U);
  EXPECT_EQ(rock.cleaned[0].what, Cleaning::line_not_used);  // the edge of one block
  EXPECT_EQ(rock.cleaned[1].what, Cleaning::line_not_used);  // no block at all
  EXPECT_EQ(rock.cleaned[2].what, Cleaning::line_without_length);
}

TEST(GivenBlocks, NothingIsCut) {
  for (const PlanLine& through : {line({-1, 0.5}, {4, 0.5}), line({0.5, 0}, {0.6, 1}), line({0.2, 0.2}, {0.3, 0.3})}) {
    RockPlan plan = squares(3);
    plan.lines = {through};
    EXPECT_THROW(cut_rock(plan), InputError);
  }
  RockPlan crossed = squares(1);
  std::swap(crossed.blocks[0].shape.outer[0], crossed.blocks[0].shape.outer[1]);
  EXPECT_THROW(cut_rock(crossed), InputError);
}

RockPlan random_lines(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto lot = [&] { return 10 * static_cast<double>(random() >> 11U) * 0x1p-53; };
  RockPlan plan;
  plan.boundary = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  plan.boundary_origin = "boundary";
  for (int i = 0; i < 15; ++i) {
    plan.lines.push_back(line({-1, lot()}, {11, lot()}));
    plan.lines.push_back(line({lot(), -1}, {lot(), 11}));
  }
  return plan;
}

// Cut with a large tolerance corners move aside; runs of joints lie along edges of blocks all the same.
TEST(GivenBlocks, RunsOfCutRockLieAlongItsBlocks) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    CutOptions options;
    options.tolerance = 0.02;
    const CutRock rock = cut_rock(random_lines(seed), options);
    RockPlan plan;
    for (const CutBlock& block : rock.blocks) plan.blocks.push_back({block.shape, "rock", "", "a block"});
    for (const CutJoint& run : rock.joints) plan.lines.push_back({{run.from, run.to}, run.joint, "a run", false});
    const CutRock again = given_rock(plan, 1e-6);
    EXPECT_EQ(again.blocks.size(), rock.blocks.size());
    EXPECT_EQ(again.joints.size(), rock.joints.size());
    EXPECT_TRUE(again.cleaned.empty());
  }
}

}  // namespace
}  // namespace dda
