// What must hold for any lines, checked by geometry that knows nothing of how blocks are found.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/cutting/cut_rock.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

RockPlan random_plan(Lots& lots, int lines) {
  RockPlan plan = square_plan();
  for (int i = 0; i < lines; ++i) add_line(plan, {lots.point(-2, 12), lots.point(-2, 12)});
  return plan;
}

// Lines on a coarse grid, some of them moved by about the tolerance or by round-off: crossings in one point, ends on
// lines, lines along each other and along the boundary.
RockPlan degenerate_plan(Lots& lots, int lines) {
  RockPlan plan = square_plan();
  const double moves[] = {0, 0, 0, 1e-15, 1e-12, 1e-9, 5e-6, 1.4e-5, 3e-5};
  const auto point = [&] {
    const Vec2 shift = moves[lots.whole(0, 8)] * lots.point(-1, 1);
    return Vec2(Vec2(lots.whole(0, 5), lots.whole(0, 5)) * 2 + shift);
  };
  for (int i = 0; i < lines; ++i) add_line(plan, {point(), point()});
  return plan;
}

void expect_same(const std::vector<Signature>& a, const std::vector<Signature>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  // Sorted by area, which round-off may exchange: look for each block near its place.
  for (const auto& [area, x, y] : a) {
    const double wanted_area = area;
    const double wanted_x = x;
    const double wanted_y = y;
    const auto low = std::lower_bound(b.begin(), b.end(), Signature(wanted_area - tolerance, -1e300, -1e300));
    const bool found = std::any_of(low, b.end(), [&](const Signature& other) {
      const auto& [other_area, other_x, other_y] = other;
      return std::abs(other_area - wanted_area) <= tolerance && std::abs(other_x - wanted_x) <= 1e3 * tolerance &&
             std::abs(other_y - wanted_y) <= 1e3 * tolerance;
    });
    EXPECT_TRUE(found) << wanted_area << " at " << wanted_x << ", " << wanted_y;
  }
}

TEST(CutProperties, RandomLinesFillTheRockOnce) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    const RockPlan plan = random_plan(lots, lots.whole(1, 60));
    const CutRock rock = cut_rock(plan);
    expect_sound(rock, plan);
    expect_no_overlap(rock, 1e-9);
    expect_euler(rock);
  }
}

TEST(CutProperties, SoDoDegenerateOnes) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    const RockPlan plan = degenerate_plan(lots, lots.whole(1, 30));
    const CutRock rock = cut_rock(plan);
    expect_sound(rock, plan);
    expect_no_overlap(rock, 1e-9);
    expect_euler(rock);
  }
}

TEST(CutProperties, TheOrderOfLinesAndTheirDirectionDoNotMatterToTheBit) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    RockPlan plan = seed % 2 == 0 ? random_plan(lots, 40) : degenerate_plan(lots, 25);
    const CutRock rock = cut_rock(plan);
    std::shuffle(plan.lines.begin(), plan.lines.end(), lots.bits());
    for (PlanLine& line : plan.lines) {
      if (lots.whole(0, 1) == 1) std::swap(line.points.front(), line.points.back());
    }
    const CutRock again = cut_rock(plan);
    ASSERT_EQ(rock.blocks.size(), again.blocks.size());
    for (std::size_t i = 0; i < rock.blocks.size(); ++i) {
      EXPECT_EQ(rock.blocks[i].shape.outer, again.blocks[i].shape.outer);
      EXPECT_EQ(rock.blocks[i].shape.holes, again.blocks[i].shape.holes);
    }
  }
}

// Round-off: coordinates of 1e3 m have one of 1e-13 m, and a crossing at an angle of 1e-3 a thousand times that.
TEST(CutProperties, NeitherDoesWhereTheRockLiesAndHowItIsTurned) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    RockPlan plan = random_plan(lots, 30);
    CutOptions options;
    options.tolerance = 1e-5;
    const auto before = signatures_of(cut_rock(plan, options));
    const double angle = lots.between(0, 2 * std::numbers::pi);
    const Vec2 shift = lots.point(-100, 100);
    const Vec2 x(std::cos(angle), std::sin(angle));
    const Vec2 y(-x.y(), x.x());
    const auto move = [&](Vec2& point) { point = shift + point.x() * x + point.y() * y; };
    for (Vec2& point : plan.boundary) move(point);
    for (PlanLine& line : plan.lines) {
      for (Vec2& point : line.points) move(point);
    }
    std::vector<Signature> after;
    for (const auto& [area, at_x, at_y] : signatures_of(cut_rock(plan, options))) {
      const Vec2 back = Vec2(at_x, at_y) - shift;
      after.emplace_back(area, back.dot(x), back.dot(y));
    }
    expect_same(before, after, 1e-10);
  }
}

// Ends that were computed to lie on a line lie beside it by round-off, many of them at the corners of one block.
TEST(CutProperties, EndsComputedToLieOnOtherLines) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    RockPlan plan = square_plan();
    for (int i = 0; i < 6; ++i) add_line(plan, {{0, lots.between(0, 10)}, {10, lots.between(0, 10)}});
    for (int i = 0; i < 40; ++i) {
      const auto on_line = [&] {
        const PlanLine& line = plan.lines[static_cast<std::size_t>(lots.whole(0, 5))];
        return point_at({line.points[0], line.points[1]}, lots.between(0, 1));
      };
      const Vec2 from = on_line();
      const Vec2 to = on_line();
      add_line(plan, {from, to});
      add_line(plan, {from, lots.point(0, 10)});
    }
    const CutRock rock = cut_rock(plan);
    expect_sound(rock, plan);
    expect_euler(rock);
  }
}

// With lines from side to side nothing is trimmed, and their number of blocks is known: one, and one more for every
// line and every crossing.
TEST(CutProperties, LinesFromSideToSideMakeAsManyBlocksAsTheyCross) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    RockPlan plan = square_plan();
    std::vector<Segment> lines;
    for (int i = 0; i < 25; ++i) {
      lines.push_back({{0, lots.between(0, 10)}, {10, lots.between(0, 10)}});
      add_line(plan, {lines.back().start, lines.back().end});
    }
    std::size_t expected = 1 + lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (proper_intersection(lines[i], lines[j])) ++expected;
      }
    }
    const CutRock rock = cut_rock(plan);
    EXPECT_EQ(rock.blocks.size() + static_cast<std::size_t>(rock.merged), expected);
    EXPECT_EQ(rock.dangles_trimmed, 0);
  }
}

// All along a line two blocks touch there, but for the parts that are said to be trimmed.
TEST(CutProperties, JointsCoverTheLinesLessWhatIsReported) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Lots lots(seed);
    RockPlan plan = square_plan();
    double length = 0;
    for (int i = 0; i < 40; ++i) {
      add_line(plan, {lots.point(0, 10), lots.point(0, 10)});
      length += (plan.lines.back().points[1] - plan.lines.back().points[0]).norm();
    }
    const CutRock rock = cut_rock(plan);
    double joints = 0;
    for (const CutJoint& run : rock.joints) joints += (run.to - run.from).norm();
    double trimmed = 0;
    double moved = 0;  // where a corner moves, up to four lines change their length by as much
    for (const Cleaned& each : rock.cleaned) {
      if (each.what == Cleaning::dangle_trimmed) trimmed += each.size;
      if (each.what == Cleaning::short_edge_closed || each.what == Cleaning::touching_parted) moved += 4 * each.size;
      if (each.what == Cleaning::sliver_merged) moved += 4 * rock.tolerance;
    }
    EXPECT_NEAR(joints + trimmed, length, 1e-9 + moved);
  }
}

// Three lines that make a triangle of the size of round-off, two corners of which are further apart than it: links
// beside the other's end changed places in every round, until the last one allowed.
TEST(CutProperties, TrianglesOfTheSizeOfRoundOffComeToAnEnd) {
  const RockPlan square = square_plan(100);
  const double round_off = 1e-8 * std::sqrt(2) * 100;
  for (const double apart : {1.001, 1.02, 1.1, 1.2, 1.3}) {
    for (const double angle : {55., 60., 70., 75.}) {
      SCOPED_TRACE(testing::Message() << apart << " apart, " << angle << " deg");
      const double half = apart * round_off / 2;
      const Vec2 a(50, 50 + half);
      const Vec2 b(50, 50 - half);
      const Vec2 c(50 + half * std::tan(angle * std::numbers::pi / 180), 50);
      RockPlan plan = square;
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(a, c)}) {
        const Vec2 along = (to - from).normalized();
        add_line(plan, {from - 20 * along, to + 20 * along});
      }
      const CutRock rock = cut_rock(plan);
      EXPECT_LE(rock.pieces_noded, 60u);  // 13 to begin with, and some again
      expect_sound(rock, plan);
    }
  }
}

// Blocks in a row that become one after the other part of a neighbour take rounds, and each looks at these blocks only.
TEST(CutProperties, SomeSmallBlocksDoNotCostAnotherLookAtAll) {
  Lots lots(11);
  RockPlan plan = square_plan();
  for (int i = 0; i < 100; ++i) add_line(plan, {lots.point(0, 10), lots.point(0, 10)});
  for (int i = 0; i < 20; ++i) add_line(plan, {{1 + 1e-3 * i, 0.1}, {1 + 1e-3 * i, 9.9}});
  CutOptions options;
  options.least_area = 1e-3;
  const CutRock rock = cut_rock(plan, options);
  EXPECT_GT(rock.merged, 100);
  const std::size_t at_first = rock.blocks.size() + static_cast<std::size_t>(rock.merged);
  EXPECT_LE(rock.outlines_traced, at_first + 2 * static_cast<std::size_t>(rock.merged));
  expect_sound(rock, plan);
}

// Rock around thin wedges takes in one after the other, a round each; its outline is looked at once more, at the end.
TEST(CutProperties, ManySliversInOneBlockDoNotCostALookEach) {
  RockPlan plan = square_plan();  // with the tolerance 1.4e-5 m; a wedge is 2.5e-6 m wide, by area and perimeter
  for (int i = 0; i < 50; ++i) {
    const Vec2 tip(0.1 * i + 1, 0.05 * i + 1);
    const Vec2 to(0.05, 0);
    add_line(plan, {tip, tip + to, tip + to + Vec2(0, 5e-6), tip});
  }
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks.size(), 1U);
  EXPECT_EQ(rock.merged, 50);
  EXPECT_EQ(rock.outlines_traced, 51U + 1U);
  expect_sound(rock, plan);
}

// What is welded is noded again, and what is far from there is not: an end beside a line costs no second pass over
// thousands of lines.
TEST(CutProperties, OneEndBesideALineDoesNotCostAnotherNoding) {
  Lots lots(7);
  RockPlan plan = square_plan();
  for (int i = 0; i < 3000; ++i) {
    const Vec2 from = lots.point(1, 9);
    add_line(plan, {from, from + lots.point(-1, 1)});
  }
  add_line(plan, {{0.1, 1}, {0.1, 9}});
  add_line(plan, {{0.1 + 5e-8, 5}, {0.9, 7}});
  const CutRock rock = cut_rock(plan);
  EXPECT_GE(count(rock, Cleaning::round_off_closed), 1);
  const auto at_first = static_cast<double>(4 + 3 * plan.lines.size());  // a line and what prolongs it at both ends
  EXPECT_LT(static_cast<double>(rock.pieces_noded), 1.05 * at_first);
}

}  // namespace
}  // namespace dda
