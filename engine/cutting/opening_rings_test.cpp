#include "engine/cutting/opening_rings.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/core/error.h"
#include "engine/cutting/cut_rock.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/cutting/opening_shapes.h"

namespace dda {
namespace {

OpeningRings rings(int count, double thickness, int cuts, double growth = 1) {
  return {count, thickness, growth, cuts, "intact", "openings[0].rings"};
}

CutRock cut_with(const Ring& outline, const OpeningRings& wanted) {
  RockPlan plan = square_plan(40);
  plan.openings.push_back({"tunnel", outline, "", true, "openings[0]"});
  plan.lines = rings_around(outline, wanted);
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, [&] {
    RockPlan hole = plan;
    hole.holes.push_back(outline);
    return hole;
  }());
  EXPECT_TRUE(rock.cleaned.empty());
  return rock;
}

// A circle of n chords: each ring has as many blocks as cuts, and one block is around them.
TEST(OpeningRings, DivideTheRockAroundACircle) {
  const CutRock rock = cut_with(circle({20, 20}, 3, 0.02), rings(4, 0.5, 12));
  EXPECT_EQ(rock.blocks.size(), 4U * 12U + 1U);
}

// Edges stay parallel at the distance of the ring: areas by Steiner's formula for mitred corners, A + P d + m d^2 with
// m = n tan(pi/n) for a regular polygon of n sides.
TEST(OpeningRings, LieAtTheirDistances) {
  const Ring outline = circle({20, 20}, 3, 0.02);
  const auto n = static_cast<double>(outline.size());
  const double m = n * std::tan(std::numbers::pi / n);
  double perimeter = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) perimeter += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  const std::vector<PlanLine> lines = rings_around(outline, rings(3, 0.5, 8, 1.5));
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    distance += 0.5 * std::pow(1.5, static_cast<double>(i));
    Ring ring = lines[i].points;
    ring.pop_back();
    EXPECT_NEAR(signed_area(ring), signed_area(outline) + perimeter * distance + m * distance * distance, 1e-10);
  }
}

// 4 corners and a cut each 1 m between: 6 m + 6 m + 4 m + 4 m give 20 cuts.
TEST(OpeningRings, CutsLeaveCorners) {
  const CutRock rock = cut_with(rectangle({20, 15}, 6, 4), rings(2, 1, 20));
  EXPECT_EQ(rock.blocks.size(), 2U * 20U + 1U);
  const CutRock few = cut_with(rectangle({20, 15}, 6, 4), rings(1, 1, 1));
  EXPECT_EQ(few.blocks.size(), 4U + 1U);
}

TEST(OpeningRings, CutsMakeSquaresWhenNoNumberIsAsked) {
  const CutRock rock = cut_with(rectangle({20, 15}, 6, 4), rings(1, 1, 0));
  EXPECT_EQ(rock.blocks.size(), 20U + 1U);
}

TEST(OpeningRings, GoAroundAnyTunnel) {
  cut_with(horseshoe({20, 15}, 6, 7, 0.02), rings(5, 0.4, 24, 1.3));
  cut_with(arch({20, 15}, 6, 5, 2, 0.02), rings(5, 0.4, 24, 1.3));
  cut_with(Ring{{18, 18}, {24, 18}, {24, 24}, {21, 20}}, rings(2, 0.4, 24));  // with a corner that points inwards
}

TEST(OpeningRings, ThatMeetThemselvesAreRefused) {
  const Ring slot{{10, 10}, {20, 10}, {20, 20}, {16, 20}, {16, 12}, {14, 12}, {14, 20}, {10, 20}};
  EXPECT_NO_THROW(rings_around(slot, rings(1, 0.5, 20)));
  EXPECT_THROW(rings_around(slot, rings(3, 0.5, 20)), InputError);
}

}  // namespace
}  // namespace dda
