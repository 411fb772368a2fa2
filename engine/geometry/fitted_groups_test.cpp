#include "engine/geometry/fitted_groups.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>

#include "engine/geometry/overlap.h"
#include "engine/geometry/random_polygon.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::vector<int> groups_of(const std::vector<Polygon>& polygons) {
  std::vector<const Polygon*> all;
  for (const Polygon& polygon : polygons) all.push_back(&polygon);
  return groups_that_fit(all);
}

const Polygon left{box(0, 0, 1, 1), {}};
const Polygon right{box(1, 0, 2, 1), {}};
const Polygon frame{box(0, 0, 4, 4), {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
const Polygon plug{box(1, 1, 3, 3), {}};

TEST(GroupsThatFit, AreNeighboursThatHaveASideInCommon) {
  EXPECT_EQ(groups_of({left, right}), (std::vector{0, 0}));
  EXPECT_EQ(groups_of({{box(5, 5, 6, 6), {}}, left, right}), (std::vector{no_group, 1, 1}));
  EXPECT_EQ(groups_of({frame, plug}), (std::vector{0, 0}));
  EXPECT_EQ(groups_of({{{{0, 0}, {1, 0}, {1, 1}}, {}}, {{{-0.0, 0}, {1, 1}, {0, 1}}, {}}}), (std::vector{0, 0}));
}

TEST(GroupsThatFit, SayNothingOfOthers) {
  const std::vector<int> nothing{no_group, no_group};
  EXPECT_EQ(groups_of({left}), std::vector{no_group});
  EXPECT_EQ(groups_of({left, {box(1, 0.25, 2, 0.75), {}}}), nothing);  // beside each other, but for their corners
  EXPECT_EQ(groups_of({left, {box(1, 0, 2, 1.0000001), {}}}), nothing);
  EXPECT_EQ(groups_of({left, {box(1, 1, 2, 2), {}}}), nothing);  // a corner alone
}

TEST(GroupsThatFit, HaveNoneThatOverlaps) {
  const std::vector<int> nothing(3, no_group);
  EXPECT_EQ(groups_of({left, right, right}), nothing);
  EXPECT_EQ(groups_of({frame, plug, plug}), nothing);
  EXPECT_EQ(groups_of({left, right, {{{1, 1}, {1, 0}, {0.5, 0.5}}, {}}}), nothing);  // on its side, within another
  EXPECT_EQ(groups_of({left, left}), (std::vector{no_group, no_group}));
  EXPECT_EQ(groups_of({frame, {box(1.5, 1.5, 2, 2), {}}, plug}), (std::vector{0, no_group, 0}));  // within, by itself
}

// Places that are gone around twice, though no side has two on its left: strips around a tower, a turn and a half.
TEST(GroupsThatFit, HaveNoneThatOverlapsFarAlongTheGroup) {
  const std::vector<Ring> turns{box(0, 0, 1, 1),
                                box(1, 0, 2, 1),
                                {{2, 0}, {3, 0}, {3, 1}, {2, 1}},
                                {{3, 1}, {3, 2}, {2, 2}, {2, 1}},
                                {{2, 1}, {2, 2}, {0.5, 2}, {0.5, 0.5}, {0.75, 0.5}}};
  std::vector<Polygon> polygons;
  for (const Ring& ring : turns) polygons.push_back({ring, {}});
  EXPECT_TRUE(interiors_overlap(polygons.front(), polygons.back(), 1e-9));
  EXPECT_EQ(groups_of(polygons), std::vector<int>(5, no_group));
}

using Grid = std::vector<std::vector<Vec2>>;

// Corners of cells that fill a square, none where a grid would have it.
Grid random_corners(std::size_t side) {
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  Grid corners(side + 1, std::vector<Vec2>(side + 1));
  for (std::size_t i = 0; i <= side; ++i) {
    for (std::size_t j = 0; j <= side; ++j)
      corners[i][j] = turn * (Vec2(static_cast<double>(i), static_cast<double>(j)) + random::point(0.2)) + Vec2(50, 70);
  }
  return corners;
}

// Quadrilaterals between them, some as two triangles, and some left out where there are to be gaps.
std::vector<Polygon> random_cells(std::size_t side, bool with_gaps) {
  const Grid corner = random_corners(side);
  std::vector<Polygon> cells;
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) {
      const Vec2 &a = corner[i][j], &b = corner[i + 1][j], &c = corner[i + 1][j + 1], &d = corner[i][j + 1];
      const int kind = random::integer(0, 4);
      if (kind == 0 && with_gaps) continue;
      if (kind > 2) {
        cells.push_back({{a, b, c, d}, {}});
      } else {
        cells.push_back({{a, b, c}, {}});
        cells.push_back({{c, d, a}, {}});
      }
    }
  }
  return cells;
}

RC_GTEST_PROP(GroupsThatFitProperty, AreOneWhereCellsFillASquare, ()) {
  const std::vector<Polygon> cells = random_cells(5, false);
  RC_ASSERT(groups_of(cells) == std::vector<int>(cells.size(), 0));
}

// Moves a corner of one cell alone, doubles a cell, or lays one over all.
void damage(std::vector<Polygon>& cells) {
  const auto any = static_cast<std::size_t>(random::integer(0, static_cast<int>(cells.size()) - 1));
  switch (random::integer(0, 3)) {
    case 0: cells[any].outer.front() += random::point(0.3); break;
    case 1: cells.push_back(cells[any]); break;
    case 2: cells.push_back(random::transformed(random::polygon(), Mat2::Identity(), cells[any].outer.front())); break;
    default: break;
  }
}

// What is said is what pairs of polygons say.
RC_GTEST_PROP(GroupsThatFitProperty, HaveNoTwoThatOverlap, ()) {
  std::vector<Polygon> cells = random_cells(4, true);
  RC_PRE(!cells.empty());
  for (int i = random::integer(0, 2); i > 0; --i) damage(cells);
  for (Polygon& cell : cells) {
    RC_PRE(!defect(cell));
    cell = normalized(cell);
  }
  const std::vector<int> groups = groups_of(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = i + 1; j < cells.size(); ++j)
      RC_ASSERT(groups[i] == no_group || groups[i] != groups[j] || !interiors_overlap(cells[i], cells[j], 1e-9));
  }
}

}  // namespace
}  // namespace dda
