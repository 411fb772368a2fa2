#include "engine/geometry/near_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace dda {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

std::vector<const Ring*> pointers_to(const std::vector<Ring>& shapes) {
  std::vector<const Ring*> pointers;
  for (const Ring& shape : shapes) pointers.push_back(&shape);
  return pointers;
}

std::vector<Box> boxes_of(const std::vector<Ring>& shapes) {
  std::vector<Box> boxes;
  for (const Ring& shape : shapes) boxes.push_back(bounding_box(shape));
  return boxes;
}

Vec2 turned(double angle, const Vec2& place) {
  return {std::cos(angle) * place.x() - std::sin(angle) * place.y(),
          std::sin(angle) * place.x() + std::cos(angle) * place.y()};
}

Ring strip(double angle, double bottom, double width, double length) {
  return {turned(angle, {0, bottom}), turned(angle, {length, bottom}), turned(angle, {length, bottom + width}),
          turned(angle, {0, bottom + width})};
}

std::vector<Ring> strips(double angle, int count) {
  std::vector<Ring> shapes;
  for (int i = 0; i < count; ++i) shapes.push_back(strip(angle, 100.0 * i / count, 100.0 / count, 100));
  return shapes;
}

// Rods at any place and angle, a few of them long.
std::vector<Ring> rods(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Ring> shapes;
  for (int i = 0; i < count; ++i) {
    Ring rod = strip(2 * std::numbers::pi * unit(random), 10 * unit(random), 0.2 * unit(random),
                     std::pow(10, 1.5 * unit(random)));
    const Vec2 shift(10 * unit(random), 10 * unit(random));
    for (Vec2& vertex : rod) vertex += shift;
    shapes.push_back(std::move(rod));
  }
  return shapes;
}

bool have_common_point(const Ring& a, const Ring& b) {
  if (locate({a, {}}, b.front()) != Location::outside || locate({b, {}}, a.front()) != Location::outside) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Segment edge{a[i], a[(i + 1) % a.size()]};
      if (distance(edge, Segment{b[j], b[(j + 1) % b.size()]}) == 0) return true;
    }
  }
  return false;
}

// Their boxes alone have some 2,000,000 pairs.
TEST(NearShapes, StripsMeetTheirNeighboursOnly) {
  constexpr int count = 3000;
  for (const double angle : {0.3, 0.785398, 1.2, 2.5}) {
    const std::vector<Ring> shapes = strips(angle, count);
    const Pairs pairs = pairs_of_near_shapes(pointers_to(shapes), boxes_of(shapes));
    EXPECT_LT(pairs.size(), 5U * count);
    const std::set<std::pair<int, int>> found(pairs.begin(), pairs.end());
    for (int i = 1; i < count; ++i) EXPECT_TRUE(found.contains({i - 1, i})) << i;
  }
}

// Two sets beside each other, as at a fault.
TEST(NearShapes, StripsOfTwoDirections) {
  constexpr int count = 2000;
  std::vector<Ring> shapes = strips(0.4, count);
  for (Ring& shape : strips(2.2, count)) shapes.push_back(std::move(shape));
  EXPECT_LT(pairs_of_near_shapes(pointers_to(shapes), boxes_of(shapes)).size(), 20U * count);
}

TEST(NearShapes, FindsAllThatMeetAndNoneWhoseBoxesDoNot) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<Ring> shapes = rods(seed, 150);
    const std::vector<Box> boxes = boxes_of(shapes);
    const Pairs pairs = pairs_of_near_shapes(pointers_to(shapes), boxes);
    EXPECT_TRUE(std::ranges::is_sorted(pairs));
    const std::set<std::pair<int, int>> found(pairs.begin(), pairs.end());
    EXPECT_EQ(found.size(), pairs.size());
    const Pairs of_boxes = overlapping_pairs(boxes);
    for (const auto& pair : pairs) EXPECT_TRUE(std::ranges::binary_search(of_boxes, pair));
    for (const auto& [i, j] : of_boxes) {
      const bool meet = have_common_point(shapes[static_cast<std::size_t>(i)], shapes[static_cast<std::size_t>(j)]);
      EXPECT_TRUE(!meet || found.contains({i, j})) << seed << ": " << i << ", " << j;
    }
  }
}

TEST(ShapeIndex, FindsStripsAtAPlace) {
  constexpr int count = 2000;
  const std::vector<Ring> shapes = strips(0.7, count);
  const ShapeIndex index(pointers_to(shapes));
  for (int i = 1; i < count; i += 7) {
    const Vec2 corner = shapes[static_cast<std::size_t>(i)][0];
    const std::vector<int> found = index.near(expanded(Box{corner, corner}, 1e-6));
    EXPECT_TRUE(std::ranges::binary_search(found, i - 1));
    EXPECT_TRUE(std::ranges::binary_search(found, i));
    EXPECT_LT(found.size(), 6U);
  }
}

TEST(ShapeIndex, FindsStripsAlongALine) {
  constexpr int count = 2000;
  const std::vector<Ring> shapes = strips(0.7, count);
  const ShapeIndex index(pointers_to(shapes));
  for (int i = 1; i < count; i += 7) {
    const Ring& strip = shapes[static_cast<std::size_t>(i)];
    const std::vector<int> found = index.near(Segment{strip[0], strip[1]}, 1e-6);
    EXPECT_TRUE(std::ranges::binary_search(found, i - 1));
    EXPECT_TRUE(std::ranges::binary_search(found, i));
    EXPECT_LT(found.size(), 6U);
  }
  EXPECT_EQ(index.near(Segment{shapes.front()[0], shapes.back()[3]}, 1e-6).size(), static_cast<std::size_t>(count));
}

TEST(ShapeIndex, NothingAndFarAway) {
  EXPECT_TRUE(ShapeIndex({}).near({Vec2(0, 0), Vec2(1, 1)}).empty());
  EXPECT_TRUE(pairs_of_near_shapes({}, {}).empty());
  const std::vector<Ring> shapes = strips(0.7, 100);
  EXPECT_TRUE(ShapeIndex(pointers_to(shapes)).near({Vec2(500, 500), Vec2(501, 501)}).empty());
}

}  // namespace
}  // namespace dda
