// Cells that fill rock: they fill it once, whatever the joints; they have the sizes that were asked.
#include "engine/cutting/fill_rock.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/core/error.h"
#include "engine/cutting/cell_size.h"
#include "engine/cutting/cut_rock.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/cutting/opening_shapes.h"

namespace dda {
namespace {

PlanFill cells_of(double size, std::uint64_t seed = 1) {
  PlanFill fill;
  fill.size = size;
  fill.relax = 10;
  fill.short_edge = 0.1;
  fill.seed = seed;
  fill.joint = "cells";
  fill.origin = "fill[0]";
  return fill;
}

void add_hole(RockPlan& plan, Lots& lots) {
  const Vec2 centre = lots.point(3, 7);
  plan.openings.push_back({"tunnel", circle(centre, lots.between(0.3, 2), 0.02), "", lots.whole(0, 1) == 1, "tunnel"});
}

RockPlan random_filled_plan(Lots& lots, unsigned seed) {
  RockPlan plan = square_plan();
  for (int i = lots.whole(0, 6); i > 0; --i) add_line(plan, {lots.point(-2, 12), lots.point(-2, 12)});
  plan.fills.push_back(cells_of(lots.between(0.4, 3), seed));
  PlanFill& fill = plan.fills.back();
  fill.relax = lots.whole(0, 12);
  fill.short_edge = lots.between(0, 0.4);
  if (lots.whole(0, 1) == 1) {
    add_hole(plan, lots);
    fill.fine_at.push_back(plan.openings.back().outline);
    fill.finest = fill.size * lots.between(0.2, 0.9);
    fill.growth = lots.between(0.05, 1);
  }
  if (lots.whole(0, 2) == 0) fill.region = {lots.point(0, 3), {9, lots.between(0, 2)}, lots.point(7, 12)};
  return plan;
}

TEST(Fill, CellsFillAnyRockOnce) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    const RockPlan plan = random_filled_plan(lots, seed);
    const CutRock rock = cut_rock(plan);
    for (const CutBlock& block : rock.blocks) EXPECT_FALSE(defect(block.shape).has_value());
    const double expected = rock.boundary_area - rock.left_out_area - rock.dropped_area;
    EXPECT_NEAR(total_area(rock), expected, 1e-12 * rock.boundary_area);
    expect_no_overlap(rock, 1e-9);
    expect_euler(rock, rock.left_out_area > 0 ? 1 : 0);
    // Blocks are filled up to their outline, which leaves lines where corners were closed or set aside, by up to twice
    // the tolerance.
    for (const Cleaned& cleaned : rock.cleaned)
      EXPECT_TRUE(cleaned.origin != "fill[0]" || cleaned.what == Cleaning::short_edge_closed ||
                  (cleaned.what == Cleaning::dangle_trimmed && cleaned.size <= 2 * rock.tolerance))
          << to_string(cleaned.what) << " " << cleaned.size;
    for (int i = 0; i < 20; ++i) {
      const Vec2 point = lots.point(0, 10);
      const bool left_out = !plan.openings.empty() && plan.openings[0].left_out &&
                            locate({plan.openings[0].outline, {}}, point) == Location::inside;
      EXPECT_EQ(blocks_around(rock, point), left_out ? 0 : 1) << point.transpose();
    }
  }
}

// Where no block is too small, the number of cells is the area over the square of the size; short edges that are closed
// around a triangle cost one.
TEST(Fill, CellsAreAsManyAsHaveRoom) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RockPlan plan = square_plan(20);
    plan.fills.push_back(cells_of(0.8, seed));
    const CutRock rock = cut_rock(plan);
    ASSERT_EQ(rock.fills.size(), 1U);
    EXPECT_EQ(rock.fills[0].sites, 625U);
    EXPECT_EQ(rock.fills[0].blocks, 1U);
    EXPECT_NEAR(static_cast<double>(rock.blocks.size()), 625, 2);
  }
}

double deviation_of_sizes(const CutRock& rock) {
  double sum = 0;
  double squares = 0;
  for (const CutBlock& block : rock.blocks) {
    const double area = area_moments(block.shape).area;
    sum += area;
    squares += area * area;
  }
  const auto count = static_cast<double>(rock.blocks.size());
  return std::sqrt(squares / count - (sum / count) * (sum / count)) / (sum / count);
}

// Sites at random have cells whose area deviates by 0.53 of its mean (Kiang 1966: 0.5295); here they are drawn one in
// each of many equal parts, which spreads them more evenly. Sites that are relaxed approach hexagons, as nearly as 32
// samples a cell tell: their number deviates by 1/sqrt(32) of it at most, that of samples at random.
TEST(Fill, RelaxingMakesCellsAlike) {
  double before = 1;
  for (const int relax : {0, 1, 5, 30}) {
    RockPlan plan = square_plan(30);
    plan.fills.push_back(cells_of(1));
    plan.fills[0].relax = relax;
    plan.fills[0].short_edge = 0;
    const double deviation = deviation_of_sizes(cut_rock(plan));
    EXPECT_LT(deviation, 0.9 * before) << relax;
    before = deviation;
  }
  EXPECT_LT(before, 1 / std::sqrt(32.0));
}

// Mean ratio of areas found and asked in rings around the opening. Cells that the wall and the boundary bound differ
// from free ones, so that a mean over some hundred cells is within 10 % (3 % of it by lot).
TEST(Fill, GradedCellsHaveTheSizeOfTheirPlace) {
  RockPlan plan = square_plan(40);
  plan.openings.push_back({"tunnel", circle({20, 20}, 3, 0.01), "", true, "tunnel"});
  plan.fills.push_back(cells_of(2.5));
  PlanFill& fill = plan.fills[0];
  fill.fine_at.push_back(plan.openings[0].outline);
  fill.finest = 0.4;
  fill.growth = 0.2;
  const CutRock rock = cut_rock(plan);
  for (const auto& [from, to] :
       {std::pair(3.0, 4.0), std::pair(4.0, 7.0), std::pair(7.0, 12.0), std::pair(12.0, 30.0)}) {
    double ratios = 0;
    int cells = 0;
    for (const CutBlock& block : rock.blocks) {
      const AreaMoments moments = area_moments(block.shape);
      const double away = (moments.centroid - Vec2(20, 20)).norm();
      if (away < from || away >= to) continue;
      const double size = cell_size(fill, moments.centroid);
      ratios += moments.area / (size * size);
      ++cells;
    }
    ASSERT_GT(cells, 60);
    EXPECT_NEAR(ratios / cells, 1, 0.1) << from;
  }
}

TEST(Fill, NoEdgeIsShorterThanAskedButAtTheOutline) {
  RockPlan plan = square_plan(20);
  plan.fills.push_back(cells_of(1));
  plan.fills[0].short_edge = 0.2;
  const CutRock rock = cut_rock(plan);
  EXPECT_GT(rock.fills[0].short_edges_closed, 20U);
  EXPECT_EQ(count(rock, Cleaning::short_edge_closed), static_cast<int>(rock.fills[0].short_edges_closed));
  for (const CutBlock& block : rock.blocks) {
    for_each_edge(block.shape, [&](const Vec2& a, const Vec2& b) { EXPECT_GT((a - b).norm(), 0.2); });
  }
}

// A block with room for less than two cells stays whole, whatever lies around it.
TEST(Fill, SmallBlocksStayWhole) {
  RockPlan plan = square_plan();
  for (double x = 1; x < 10; ++x) add_line(plan, {{x, -1}, {x, 11}});
  for (double y = 1; y < 5; ++y) add_line(plan, {{-1, y}, {11, y}});
  plan.fills.push_back(cells_of(0.9));
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.fills[0].blocks, 10U);  // columns above y = 4; the squares below have room for 1.2 cells
  EXPECT_EQ(std::count_if(rock.blocks.begin(), rock.blocks.end(),
                          [](const CutBlock& b) { return area_moments(b.shape).centroid.y() < 4; }),
            40);
}

TEST(Fill, ARegionIsFilledAndTheLaterFillCounts) {
  RockPlan plan = square_plan();
  plan.fills.push_back(cells_of(5));
  plan.fills.push_back(cells_of(0.5));
  plan.fills[1].region = {{2, 2}, {6, 2}, {6, 6}, {2, 6}};
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.fills[1].sites, 64U);
  EXPECT_EQ(rock.fills[0].sites, 3U);  // 84 m2 in cells of 25
  for (const CutBlock& block : rock.blocks) {
    const AreaMoments moments = area_moments(block.shape);
    const bool inside = contains({plan.fills[1].region, {}}, moments.centroid) && moments.area < 2;
    EXPECT_EQ(inside, moments.area < 2);
  }
}

TEST(Fill, WallsHaveTheJointAndDoNotCoverOthers) {
  RockPlan plan = square_plan();
  add_line(plan, {{-1, 5}, {11, 5}}, "bedding");
  plan.fills.push_back(cells_of(1));
  double bedding = 0;
  for (const CutJoint& run : cut_rock(plan).joints) {
    if (run.joint == "bedding") bedding += (run.to - run.from).norm();
    EXPECT_TRUE(run.joint == "bedding" || run.joint == "cells") << run.joint;
  }
  EXPECT_NEAR(bedding, 10, 1e-9);
}

// Where rock lies does not matter but for round-off, of 1e-14 of 200 m in places of sites and ten sweeps that move
// them; sites lie on a grid of 1e-8 of the block.
TEST(Fill, WhereTheRockLiesDoesNotMatter) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    RockPlan plan = square_plan();
    plan.fills.push_back(cells_of(1, seed));
    const auto before = signatures_of(cut_rock(plan));
    const Vec2 shift(128, -64);  // exactly added to all corners
    for (Vec2& point : plan.boundary) point += shift;
    auto after = signatures_of(cut_rock(plan));
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(std::get<0>(before[i]), std::get<0>(after[i]), 1e-5);
  }
}

TEST(Fill, SeedsGiveOtherCellsAndTheSameSeedTheSame) {
  const auto cells = [](std::uint64_t seed) {
    RockPlan plan = square_plan();
    plan.fills.push_back(cells_of(1, seed));
    return signatures_of(cut_rock(plan));
  };
  EXPECT_EQ(cells(1), cells(1));
  EXPECT_NE(cells(1), cells(2));
}

TEST(Fill, TooManyCellsAreRefused) {
  RockPlan plan = square_plan();
  plan.fills.push_back(cells_of(1e-9));
  EXPECT_THROW(cut_rock(plan), InputError);
  plan.fills[0] = cells_of(1);
  plan.openings.push_back({"tunnel", circle({5, 5}, 1, 0.01), "", true, "tunnel"});
  plan.fills[0].fine_at.push_back(plan.openings[0].outline);
  plan.fills[0].finest = 1e-6;
  plan.fills[0].growth = 0.01;
  EXPECT_THROW(cut_rock(plan), InputError);
}

}  // namespace
}  // namespace dda
