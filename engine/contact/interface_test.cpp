#include "engine/contact/interface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/builder/generators.h"
#include "engine/contact/contact_models.h"

namespace dda {
namespace {

// Coordinates of order ten carry a round-off of 1e-15; one or two are subtracted.
constexpr double round_off = 1e-13;

double total_length(const std::vector<Interface>& interfaces) {
  double sum = 0;
  for (const Interface& interface : interfaces) sum += interface.length;
  return sum;
}

// What holds for every interface: both blocks touch it, the normal is a unit vector from a into b and across it.
void expect_sound(const Model& model, const std::vector<Interface>& interfaces) {
  for (const Interface& interface : interfaces) {
    const Vec2 along = interface.to - interface.from;
    const Vec2 middle = (interface.from + interface.to) / 2;
    EXPECT_NEAR(along.norm(), interface.length, round_off);
    EXPECT_NEAR(interface.normal.norm(), 1, round_off);
    EXPECT_NEAR(interface.normal.dot(along), 0, round_off);
    const Polygon& a = model.blocks[static_cast<std::size_t>(interface.block_a)].shape;
    const Polygon& b = model.blocks[static_cast<std::size_t>(interface.block_b)].shape;
    EXPECT_EQ(locate(a, middle, model.length_tolerance), Location::boundary);
    EXPECT_EQ(locate(b, middle, model.length_tolerance), Location::boundary);
    EXPECT_EQ(locate(a, middle - 1e-3 * interface.normal), Location::inside);
    if (interface.length == 0) continue;
    EXPECT_EQ(locate(b, middle + 1e-3 * interface.normal), Location::inside);
    EXPECT_LT(interface.block_a, interface.block_b);
    // Block a on the left of from -> to.
    EXPECT_NEAR((Vec2(along.y(), -along.x()).normalized() - interface.normal).norm(), 0, round_off);
  }
}

bool sorted_by_blocks(const std::vector<Interface>& interfaces) {
  return std::is_sorted(interfaces.begin(), interfaces.end(), [](const Interface& p, const Interface& q) {
    return std::minmax(p.block_a, p.block_b) < std::minmax(q.block_a, q.block_b);
  });
}

TEST(FindInterfaces, BarHasOneBetweenNeighbours) {
  Model model = model_of(std::vector<Polygon>{});
  append_bar(model, {.length = 10, .height = 2, .block_length = 0.5});
  finish_model(model);
  const std::vector<Interface> found = find_interfaces(model);
  ASSERT_EQ(found.size(), 19U);
  expect_sound(model, found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].block_a, static_cast<int>(i));
    EXPECT_EQ(found[i].block_b, static_cast<int>(i) + 1);
    EXPECT_NEAR((found[i].normal - Vec2(1, 0)).norm(), 0, round_off);
    EXPECT_NEAR((found[i].from - Vec2(0.5 * static_cast<double>(i + 1), 0)).norm(), 0, round_off);
    EXPECT_NEAR(found[i].length, 2, round_off);
  }
}

Model grid(int columns, int rows, GridPattern pattern) {
  Model model = model_of(std::vector<Polygon>{});
  append_grid(model, {.columns = columns, .rows = rows, .block_width = 1.5, .block_height = 1, .pattern = pattern});
  finish_model(model);
  return model;
}

TEST(FindInterfaces, StackedGridHasEdgesAndNoCorners) {
  for (const double angle : {0.0, 0.3, 2.0}) {
    Model model = grid(4, 3, GridPattern::stack);
    place(model, angle, Vec2(7, -3));
    const std::vector<Interface> found = find_interfaces(model);
    ASSERT_EQ(found.size(), 3U * 3 + 4 * 2) << "angle " << angle;  // upright, lying
    expect_sound(model, found);
    EXPECT_TRUE(sorted_by_blocks(found));
    EXPECT_NEAR(total_length(found), 9 * 1.0 + 8 * 1.5, round_off);
  }
}

TEST(FindInterfaces, RunningBondHasPartialOverlaps) {
  // Rows of 4, 5 (half blocks at its ends) and 4 blocks: each joint between rows is cut into 8 halves.
  for (const double angle : {0.0, -0.8}) {
    Model model = grid(4, 3, GridPattern::running_bond);
    ASSERT_EQ(model.blocks.size(), 13U);
    place(model, angle);
    const std::vector<Interface> found = find_interfaces(model);
    ASSERT_EQ(found.size(), 2U * 8 + 3 + 4 + 3) << "angle " << angle;
    expect_sound(model, found);
    EXPECT_TRUE(sorted_by_blocks(found));
    EXPECT_NEAR(total_length(found), 2 * 6.0 + 10 * 1.0, 10 * round_off);
    for (const Interface& interface : found)
      EXPECT_TRUE(std::abs(interface.length - 0.75) < round_off || std::abs(interface.length - 1) < round_off);
  }
}

TEST(FindInterfaces, PlugFillsHole) {
  const Polygon frame{box_ring(0, 0, 4, 3), {box_ring(1, 1, 3, 2)}};
  for (const bool frame_first : {true, false}) {
    const Polygon plug{box_ring(1, 1, 3, 2), {}};
    const Model model = frame_first ? model_of({frame, plug}) : model_of({plug, frame});
    const std::vector<Interface> found = find_interfaces(model);
    ASSERT_EQ(found.size(), 4U);
    expect_sound(model, found);
    EXPECT_NEAR(total_length(found), 6, round_off);
  }
}

TEST(FindInterfaces, SmallPlugInHoleTouchesWhereItTouches) {
  const Model model = model_of({{box_ring(0, 0, 4, 3), {box_ring(1, 1, 3, 2)}}, {box_ring(1.5, 1, 2.5, 1.6), {}}});
  const std::vector<Interface> found = find_interfaces(model);
  ASSERT_EQ(found.size(), 1U);
  expect_sound(model, found);
  EXPECT_NEAR((found[0].normal - Vec2(0, 1)).norm(), 0, round_off);
  EXPECT_NEAR(found[0].length, 1, round_off);
}

TEST(FindInterfaces, ConcaveBlockTouchesTwice) {
  const Polygon angle{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {}};
  const Model model = model_of({angle, {box_ring(1, 1, 2.5, 2), {}}});
  const std::vector<Interface> found = find_interfaces(model);
  ASSERT_EQ(found.size(), 2U);
  expect_sound(model, found);
  EXPECT_NEAR(total_length(found), 1.5 + 1, round_off);
}

TEST(FindInterfaces, VertexOnEdgeIsAPointOfTheEdgesBlock) {
  const Polygon slab{box_ring(-2, -1, 2, 0), {}};
  const Polygon wedge{{{0.3, 0}, {1, 2}, {-1, 1.5}}, {}};
  for (const bool slab_first : {true, false}) {
    const Model model = slab_first ? model_of({slab, wedge}) : model_of({wedge, slab});
    const std::vector<Interface> found = find_interfaces(model);
    ASSERT_EQ(found.size(), 1U);
    expect_sound(model, found);
    EXPECT_EQ(found[0].block_a, slab_first ? 0 : 1);
    EXPECT_EQ(found[0].block_b, slab_first ? 1 : 0);
    EXPECT_EQ(found[0].length, 0);
    EXPECT_EQ(found[0].from, found[0].to);
    EXPECT_NEAR((found[0].normal - Vec2(0, 1)).norm(), 0, round_off);
    EXPECT_NEAR((found[0].from - Vec2(0.3, 0)).norm(), 0, round_off);
  }
}

TEST(FindInterfaces, PartialOverlapAddsNoPointAtItsEnds) {
  const Model model = model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(0.7, 1, 3, 2), {}}});
  const std::vector<Interface> found = find_interfaces(model);
  ASSERT_EQ(found.size(), 1U);
  expect_sound(model, found);
  EXPECT_NEAR(found[0].length, 1.3, round_off);
}

TEST(FindInterfaces, CornersThatMeetMakeNone) {
  EXPECT_TRUE(find_interfaces(model_of({{box_ring(0, 0, 1, 1), {}}, {box_ring(1, 1, 2, 2), {}}})).empty());
}

TEST(FindInterfaces, BlocksApartMakeNone) {
  EXPECT_TRUE(find_interfaces(model_of({{box_ring(0, 0, 1, 1), {}}, {box_ring(1.0001, 0, 2, 1), {}}})).empty());
}

TEST(FindInterfaces, JointOfThePair) {
  Model model = model_of({{box_ring(0, 0, 1, 1), {}}, {box_ring(1, 0, 2, 1), {}}, {box_ring(2, 0, 3, 1), {}}});
  model.joints.resize(3);
  model.joint_of_block_pair = {{{1, 2}, 2}};
  const std::vector<Interface> found = find_interfaces(model);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].joint, 0);
  EXPECT_EQ(found[1].joint, 2);
}

}  // namespace
}  // namespace dda
