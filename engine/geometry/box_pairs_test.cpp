#include "engine/geometry/box_pairs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "engine/geometry/random_polygon.h"

namespace dda {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs brute_force(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      const Box& a = boxes[static_cast<std::size_t>(i)];
      const Box& b = boxes[static_cast<std::size_t>(j)];
      if (is_empty(a) || is_empty(b)) continue;
      const bool apart = a.upper.x() < b.lower.x() || b.upper.x() < a.lower.x() || a.upper.y() < b.lower.y() ||
                         b.upper.y() < a.lower.y();
      if (!apart) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

// Boxes with sizes spread evenly over `decades` powers of ten up to 1 m, over a square of `extent` (m) at `origin`.
std::vector<Box> random_boxes(std::uint32_t seed, int count, double decades, double extent, const Vec2& origin) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec2 lower = origin + extent * Vec2(unit(random), unit(random));
    const double size = std::pow(10, -decades * unit(random));
    boxes.push_back({lower, lower + size * Vec2(unit(random), unit(random))});
  }
  return boxes;
}

std::vector<Box> tiling(int columns, int rows) {
  std::vector<Box> boxes;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      boxes.push_back({Vec2(0.1 * column, 0.1 * row), Vec2(0.1 * (column + 1), 0.1 * (row + 1))});
    }
  }
  return boxes;
}

TEST(Box, EmptyBoxesAndTouching) {
  const Box box = expanded(expanded(Box{}, Vec2(1, 2)), Vec2(0, 3));
  EXPECT_EQ(box.lower, Vec2(0, 2));
  EXPECT_EQ(box.upper, Vec2(1, 3));
  EXPECT_TRUE(is_empty(Box{}));
  EXPECT_FALSE(is_empty(Box{Vec2(1, 1), Vec2(1, 1)}));
  EXPECT_FALSE(overlap(box, Box{}));
  EXPECT_TRUE(overlap(box, Box{Vec2(1, 3), Vec2(5, 5)}));
  EXPECT_FALSE(overlap(box, Box{Vec2(1.5, 3), Vec2(5, 5)}));
  EXPECT_FALSE(overlap(box, Box{Vec2(0, 3.5), Vec2(1, 5)}));
  EXPECT_EQ(expanded(box, 0.5).lower, Vec2(-0.5, 1.5));
  EXPECT_EQ(expanded(box, 0.5).upper, Vec2(1.5, 3.5));
  EXPECT_EQ(bounding_box(Polygon{{{0, 0}, {3, 1}, {2, 5}}, {}}).upper, Vec2(3, 5));
}

TEST(OverlappingPairs, FewBoxes) {
  EXPECT_TRUE(overlapping_pairs({}).empty());
  const std::vector<Box> boxes = {{{0, 0}, {1, 1}}, {}, {{1, 1}, {2, 2}}, {{5, 5}, {6, 6}}, {{0, 0}, {9, 9}}};
  EXPECT_EQ(overlapping_pairs(boxes), (Pairs{{0, 2}, {0, 4}, {2, 4}, {3, 4}}));
}

TEST(OverlappingPairs, NeighboursOfATiling) {
  // Each of the 40 x 30 tiles touches its neighbours; the bounds are rounded, so brute force is the judge.
  const std::vector<Box> boxes = tiling(40, 30);
  EXPECT_EQ(overlapping_pairs(boxes), brute_force(boxes));
  EXPECT_GT(overlapping_pairs(boxes).size(), 3500u);
}

TEST(OverlappingPairs, DegenerateBoxes) {
  std::vector<Box> points(40, Box{Vec2(3, 4), Vec2(3, 4)});  // all alike and without size
  EXPECT_EQ(overlapping_pairs(points).size(), 40u * 39 / 2);
  for (Box& box : points) box = {};
  EXPECT_TRUE(overlapping_pairs(points).empty());
  std::vector<Box> line;  // of points, one long box over them, one empty
  for (int i = 0; i < 100; ++i) line.push_back({Vec2(i, 0), Vec2(i, 0)});
  line.push_back({Vec2(-1, 0), Vec2(1000, 0)});
  line.push_back({});
  EXPECT_EQ(overlapping_pairs(line), brute_force(line));
  std::vector<Box> pile(40, Box{Vec2(0, 0), Vec2(1, 1)});
  pile.push_back({Vec2(0.75, 0), Vec2(0.25, 1)});  // empty, for its corners are exchanged
  EXPECT_EQ(overlapping_pairs(pile).size(), 40u * 39 / 2);
}

RC_GTEST_PROP(OverlappingPairsProperty, AgreesWithBruteForce, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const int count = random::integer(0, 500);
  const double decades = random::integer(0, 5);  // up to sizes of 1e5 to 1, and more by the aspect
  const double extent = *rc::gen::elementOf(std::vector<double>{0, 0.01, 1, 10, 1000});
  const Vec2 origin = *rc::gen::elementOf(std::vector<double>{0, 1, 1e6}) * random::point(1);
  const std::vector<Box> boxes = random_boxes(seed, count, decades, extent, origin);
  RC_ASSERT(overlapping_pairs(boxes) == brute_force(boxes));
}

std::vector<int> all_overlapping(const std::vector<Box>& boxes, const Box& wanted) {
  std::vector<int> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i]) && overlap(boxes[i], wanted)) found.push_back(static_cast<int>(i));
  return found;
}

TEST(BoxIndex, OddQuestions) {
  const double far = 1e300;
  const double nan = std::nan("");
  EXPECT_TRUE(BoxIndex({}).overlapping({{-far, -far}, {far, far}}).empty());
  EXPECT_TRUE(BoxIndex({Box{}, Box{}}).overlapping({{-far, -far}, {far, far}}).empty());
  const BoxIndex index(tiling(40, 30));
  EXPECT_EQ(index.overlapping({{-far, -far}, {far, far}}).size(), 1200u);
  EXPECT_TRUE(index.overlapping({{far, far}, {far, far}}).empty());
  EXPECT_TRUE(index.overlapping({{nan, 1}, {nan, 1}}).empty());
  EXPECT_TRUE(index.overlapping({}).empty());
  EXPECT_EQ(index.overlapping({{0.05, 0.05}, {0.05, 0.05}}), std::vector<int>{0});
}

// The extent of these is no number, nor are the cells that it would be cut into. (Found by a fuzzer of files.)
TEST(BoxIndex, BoxesFartherApartThanNumbersGo) {
  std::vector<Box> boxes;
  for (const double at : {-1.5e308, -1e300, 0.0, 1.0, 1.5e308})
    for (int i = 0; i < 10; ++i) boxes.push_back({{at, at}, {at + i, at}});
  const BoxIndex index(boxes);
  for (const Box& own : boxes) EXPECT_EQ(index.overlapping(own), all_overlapping(boxes, own));
  EXPECT_EQ(overlapping_pairs(boxes), brute_force(boxes));
}

RC_GTEST_PROP(BoxIndexProperty, AgreesWithLookingAtAll, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const double decades = random::integer(0, 5);
  const double extent = *rc::gen::elementOf(std::vector<double>{0, 0.01, 1, 10, 1000});
  const std::vector<Box> boxes = random_boxes(seed, random::integer(0, 300), decades, extent, Vec2::Zero());
  const BoxIndex index(boxes);
  for (const Box& wanted : random_boxes(seed + 1, 20, decades, 1.2 * extent, Vec2(-0.1 * extent, -0.1 * extent)))
    RC_ASSERT(index.overlapping(wanted) == all_overlapping(boxes, wanted));
  for (const Box& own : boxes) RC_ASSERT(index.overlapping(own) == all_overlapping(boxes, own));
}

TEST(OverlappingPairs, ManyBoxesOfManySizesAreQuick) {
  // 200,000 boxes, sizes over four decades: all pairs would be 2e10 comparisons, about a minute.
  const std::vector<Box> boxes = random_boxes(1, 200'000, 4, 300, Vec2::Zero());
  EXPECT_GT(overlapping_pairs(boxes).size(), 1000u);
}

}  // namespace
}  // namespace dda
