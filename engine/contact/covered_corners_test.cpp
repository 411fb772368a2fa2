// Corners of four blocks that meet in a point, or nearly.
#include "engine/contact/covered_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_search.h"

namespace dda {
namespace {

constexpr int upper_left = 0, upper_right = 1, lower_left = 2, lower_right = 3;

// Boxes of 1 m around the origin, each moved by its own shift.
struct Corners {
  std::vector<Vec2> shift = std::vector<Vec2>(4, Vec2::Zero());
  std::vector<bool> there = std::vector<bool>(4, true);
  double angle = 0;

  // The pairs of blocks in contact, by their names above.
  [[nodiscard]] std::set<std::pair<int, int>> pairs(bool with_joints = false) const {
    const std::vector<Vec2> low{{-1, 0}, {0, 0}, {-1, -1}, {0, -1}};
    std::vector<Polygon> boxes;
    std::vector<int> names;
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!there[at]) continue;
      boxes.push_back({box_ring(low[at].x(), low[at].y(), low[at].x() + 1, low[at].y() + 1), {}});
      names.push_back(i);
    }
    Model model = model_of(boxes);
    place(model, angle, {3, -2});
    State state = initial_state(model);
    for (std::size_t i = 0; i < names.size(); ++i)
      state.displacement[i].head<2>() = rotation(angle) * shift[static_cast<std::size_t>(names[i])];
    const ContactSearch search(model, state);
    std::vector<std::pair<int, int>> bonded;
    std::vector<Carrier> joints;
    std::vector<VertexContact> found = search.find(bonded);
    if (with_joints) move_to_joints(search.outlines(), found, joints);
    take_out_covered(search, joints, {}, {}, found);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    std::set<std::pair<int, int>> pairs;
    for (const VertexContact& contact : found)
      pairs.insert(std::minmax(names[static_cast<std::size_t>(contact.edge_block)],
                               names[static_cast<std::size_t>(contact.vertex_block)]));
    return pairs;
  }

  // As if all that lies along an edge were a joint that holds.
  static void move_to_joints(const Outlines& outlines, std::vector<VertexContact>& found,
                             std::vector<Carrier>& joints) {
    std::erase_if(found, [&](const VertexContact& contact) {
      if (common_length(outlines, contact) < 0.1) return false;
      const Vec2& point = outlines.current[static_cast<std::size_t>(contact.vertex)];
      joints.push_back({contact.edge_block, contact.vertex_block, point, contact.normal, contact.gap});
      return true;
    });
  }
};

bool has_diagonal(const std::set<std::pair<int, int>>& pairs) {
  return pairs.contains({upper_left, lower_right}) || pairs.contains({upper_right, lower_left});
}

TEST(CoveredCorners, NeighboursOfAGridTouchAlongTheirEdgesOnly) {
  for (const double angle : {0.0, 0.7, -2.0})
    for (const double pressed : {0.0, 1e-9, 1e-5, 3e-4}) {
      Corners grid;
      grid.angle = angle;
      grid.shift = {{pressed, 0}, {0, 0}, {pressed, pressed}, {0, pressed}};
      EXPECT_EQ(grid.pairs().size(), 4U) << angle << ' ' << pressed;
      EXPECT_FALSE(has_diagonal(grid.pairs())) << angle << ' ' << pressed;
      EXPECT_FALSE(has_diagonal(grid.pairs(true))) << "joints that hold carry too";
    }
}

// The left column slides down by less than it is pressed into the right one.
TEST(CoveredCorners, AColumnPassesTheJointsBesideIt) {
  for (const double down : {1e-9, 1e-6, 1e-5, 2.9e-5}) {
    Corners grid;
    grid.shift = {{3e-5, -down}, {0, 0}, {3e-5, -down}, {0, 0}};
    EXPECT_FALSE(has_diagonal(grid.pairs())) << down;
  }
}

// Whether two wedges touch, one above the other with sides in line, that meet tip to tip on the wall beside them, which
// is one block or parts at their tips. `shift`: of the upper one, from where the tips are drawn in one point.
bool wedges_touch(const Vec2& shift, bool wall_parts, double angle) {
  std::vector<Polygon> shapes{{{{0, 0}, {0, 1}, {-1, 1}}, {}}, {{{0, 0}, {-1, -1}, {0, -1}}, {}}};
  shapes.push_back({box_ring(0, -1, 1, wall_parts ? 0 : 1), {}});
  if (wall_parts) shapes.push_back({box_ring(0, 0, 1, 1), {}});
  Model model = model_of(shapes);
  place(model, angle, {3, -2});
  State state = initial_state(model);
  state.displacement[0].head<2>() = rotation(angle) * shift;
  const ContactSearch search(model, state);
  std::vector<VertexContact> found = search.find({});
  take_out_covered(search, {}, {}, {}, found);
  return std::ranges::any_of(found, [](const VertexContact& contact) { return blocks_of(contact) == std::pair(0, 1); });
}

// A block that slides down a joint meets what ends at the joint: the wall carries both on the same side, and keeps
// neither from standing on the other.
TEST(CoveredCorners, WedgesInLineStandOnEachOther) {
  for (const double angle : {0.0, 0.7, -2.0})
    for (const double aside : {-3e-5, -1e-6, 1e-6, 3e-5})
      for (const double down : {1e-9, 1e-6, 1e-5})
        for (const bool wall_parts : {false, true})
          EXPECT_TRUE(wedges_touch({aside, -down}, wall_parts, angle)) << aside << ' ' << down << ' ' << wall_parts;
}

// Without one that carries it in line a corner hits what it meets.
TEST(CoveredCorners, AreThoseOfThirdBlocksAlone) {
  Corners two;
  two.there = {true, false, false, true};
  two.shift[upper_left] = {1e-5, -1e-6};
  EXPECT_TRUE(has_diagonal(two.pairs()));
  Corners three = two;
  three.there[upper_right] = true;
  three.shift[upper_right] = {0, 0};
  EXPECT_FALSE(has_diagonal(three.pairs())) << "comes down along the upper right one";
  for (const double aside : {0.1, 5e-3, 1.5e-3}) {
    three.shift[upper_right] = {aside, 0};
    EXPECT_TRUE(has_diagonal(three.pairs())) << "which does not touch it";
  }
  three.shift[upper_right] = {0, 0.1};
  EXPECT_TRUE(has_diagonal(three.pairs())) << "which ends above the corner";
  Corners gap = two;
  gap.there[lower_left] = true;
  gap.shift[lower_left] = {-1.5e-3, 0};
  EXPECT_TRUE(has_diagonal(gap.pairs())) << "carried from below, on both sides of a gap";
}

// Looked at with the motion of a step, in which they go at each other by more than sides in line can differ.
TEST(CoveredCorners, AreUncoveredByAStepThatPressesThemIntoEachOther) {
  const std::vector<Vec2> low{{-1, 0}, {0, 0}, {-1, -1}, {0, -1}};
  std::vector<Polygon> boxes;
  for (const Vec2& corner : low)
    boxes.push_back({box_ring(corner.x(), corner.y(), corner.x() + 1, corner.y() + 1), {}});
  const Model model = model_of(boxes);
  const ContactSearch search(model, initial_state(model));
  std::vector<VertexContact> found = search.find({});
  const std::size_t all = found.size();
  const auto covered = take_out_covered(search, {}, {}, {}, found);
  ASSERT_EQ(covered.size() + found.size(), all);
  ASSERT_FALSE(covered.empty());
  const auto unstrained = [](int, const Vec2&, double) { return 0.0; };
  const auto pressed = [&](const Vec2& of_upper_left) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(24);
    d.head<2>() = of_upper_left;
    return pressed_into_each_other(search, covered, model, initial_state(model), d, unstrained);
  };
  EXPECT_TRUE(pressed({0.9e-3, -0.9e-3}).empty());
  EXPECT_TRUE(pressed({0.1, 0.1}).empty()) << "along its neighbour below";
  EXPECT_TRUE(pressed({-0.1, -0.1}).empty()) << "away from both";
  const auto two = pressed({1.1e-3, -1.2e-3});
  ASSERT_EQ(two.size(), 1U);
  EXPECT_EQ(two[0], std::pair(upper_left, lower_right));
  const std::size_t before = found.size();
  found = search.find({});
  take_out_covered(search, {}, two, {}, found);
  EXPECT_GT(found.size(), before) << "those of the pair stay";
}

TEST(CoveredCorners, LedgesCarry) {
  for (const double ledge : {0.5e-3, 2e-3}) {
    Corners step;
    step.there = {true, true, false, true};
    step.shift[lower_right] = {-ledge, 0};
    EXPECT_EQ(has_diagonal(step.pairs()), ledge > in_line);
  }
}

}  // namespace
}  // namespace dda
