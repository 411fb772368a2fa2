#include "engine/geometry/overlap.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/geometry/random_polygon.h"
#include "engine/geometry/rotation.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Polygon block(double x0, double y0, double x1, double y1) { return {box(x0, y0, x1, y1), {}}; }

const Polygon unit = block(0, 0, 1, 1);
const Polygon l_shape = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
const Polygon frame = {box(0, 0, 4, 4), {box(1, 1, 3, 3)}};

// In every pose: turned, far from the origin, clockwise, and with the arguments exchanged.
bool overlaps(const Polygon& a, const Polygon& b) {
  const bool found = interiors_overlap(a, b, tolerance);
  EXPECT_EQ(interiors_overlap(b, a, tolerance), found);
  for (const double angle : {0.1, 0.7853981633974483, 2.5}) {
    const Vec2 shift = 1e4 * Vec2(angle, -angle);
    Polygon moved_a = random::transformed(a, rotation(angle), shift);
    std::reverse(moved_a.outer.begin(), moved_a.outer.end());
    Polygon moved_b = random::transformed(b, rotation(angle), shift);
    EXPECT_EQ(interiors_overlap(moved_a, moved_b, tolerance), found) << angle;
    std::reverse(moved_b.outer.begin(), moved_b.outer.end());
    EXPECT_EQ(interiors_overlap(moved_a, moved_b, tolerance), found) << angle;
  }
  return found;
}

TEST(InteriorsOverlap, NotWhenApartOrTouching) {
  EXPECT_FALSE(overlaps(unit, block(5, 5, 6, 6)));
  EXPECT_FALSE(overlaps(unit, block(1, 0, 2, 1)));                 // a whole edge
  EXPECT_FALSE(overlaps(unit, block(1, 0.25, 2, 0.75)));           // part of an edge
  EXPECT_FALSE(overlaps(unit, block(1, 1, 2, 2)));                 // a vertex
  EXPECT_FALSE(overlaps(unit, {{{1, 0.5}, {2, 0}, {2, 1}}, {}}));  // a vertex on an edge
  EXPECT_FALSE(overlaps(l_shape, block(1, 1, 2, 2)));              // in the notch
}

TEST(InteriorsOverlap, WhenDeeperThanTheTolerance) {
  for (const double depth : {0.9 * tolerance, 1.1 * tolerance, 0.01, 0.5}) {
    const bool deep = depth > tolerance;
    EXPECT_EQ(overlaps(unit, block(1 - depth, 0, 2, 1)), deep) << depth;                     // edge in edge, as wide
    EXPECT_EQ(overlaps(unit, block(1 - depth, -1, 2, 3)), deep) << depth;                    // wider
    EXPECT_EQ(overlaps(unit, block(1 - depth, 0.25, 2, 0.75)), deep) << depth;               // narrower
    EXPECT_EQ(overlaps(unit, block(1 - depth, 1 - depth, 2, 2)), deep) << depth;             // corner in corner
    EXPECT_EQ(overlaps(unit, {{{1 - depth, 0.5}, {2, 0.4}, {2, 0.6}}, {}}), deep) << depth;  // a point in an edge
    EXPECT_EQ(overlaps(l_shape, block(1 - depth, 1, 2, 2)), deep) << depth;
  }
}

TEST(InteriorsOverlap, WhenEdgesCrossAndNoVertexIsInside) {
  EXPECT_TRUE(overlaps(block(0, 1, 3, 2), block(1, 0, 2, 3)));
  EXPECT_TRUE(overlaps({{{0, 0}, {2, 0}, {1, 2}}, {}}, {{{0, 1.5}, {1, -0.5}, {2, 1.5}}, {}}));
}

TEST(InteriorsOverlap, WhenAlikeOrOneWithinTheOther) {
  EXPECT_TRUE(overlaps(unit, unit));
  EXPECT_TRUE(overlaps(l_shape, l_shape));
  EXPECT_TRUE(overlaps(frame, frame));
  EXPECT_TRUE(overlaps(unit, block(0.25, 0.25, 0.75, 0.75)));
  EXPECT_TRUE(overlaps(unit, block(0, 0, 0.5, 1)));  // a half, on three edges of the whole
  EXPECT_TRUE(overlaps(unit, block(1e-9, 1e-9, 1 - 1e-9, 1 - 1e-9)));
  EXPECT_TRUE(overlaps(unit, block(0.2, 0.5, 0.8, 0.5 + tolerance)));  // a sliver
  EXPECT_TRUE(overlaps(l_shape, block(0, 0, 1, 1)));
  EXPECT_TRUE(overlaps(l_shape, block(0, 0, 2, 2)));
  EXPECT_TRUE(overlaps(unit, {{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}));  // one vertex more
}

TEST(InteriorsOverlap, BlocksInHoles) {
  EXPECT_FALSE(overlaps(frame, block(1.5, 1.5, 2, 2)));            // loose
  EXPECT_FALSE(overlaps(frame, block(1, 1, 3, 3)));                // filling it
  EXPECT_FALSE(overlaps(frame, block(1 - 1e-7, 1, 3 + 1e-7, 3)));  // filling it, rounded
  EXPECT_TRUE(overlaps(frame, block(0.9, 1, 3, 3)));
  EXPECT_TRUE(overlaps(frame, block(0.5, 0.5, 3.5, 3.5)));  // around the hole
  EXPECT_TRUE(overlaps(frame, block(0, 0, 4, 4)));          // the frame without its hole
  EXPECT_TRUE(overlaps(frame, block(-1, -1, 5, 5)));
  EXPECT_FALSE(overlaps(frame, {box(-1, -1, 5, 5), {box(0, 0, 4, 4)}}));  // frame in frame
}

TEST(InteriorsOverlap, HalvesOfABlockWithANeck) {
  // Two chambers joined by a neck narrower than twice the tolerance; the other block is one chamber and half the neck.
  const double n = 0.5 * tolerance;
  const Polygon both = {
      {{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5 + n}, {1, 0.5 + n}, {1, 1}, {0, 1}},
      {}};
  const Polygon right = {{{1.5, 0.5}, {2, 0.5}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5 + n}, {1.5, 0.5 + n}}, {}};
  EXPECT_TRUE(interiors_overlap(both, right, tolerance));
  EXPECT_FALSE(interiors_overlap(both, block(1, 0, 2, 0.5), tolerance));
  EXPECT_FALSE(interiors_overlap(both, block(1, 0.5, 2, 1), tolerance));  // covers the neck, which is too narrow to see
}

// The least distance by which one of two convex polygons must move to be free of the other, or less than 0 if they are
// apart: the separating-axis theorem.
double separating_depth(const Ring& a, const Ring& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [ring, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Vec2& start = (*ring)[i];
      const Vec2 along = ((*ring)[(i + 1) % ring->size()] - start).normalized();
      double deepest = -std::numeric_limits<double>::infinity();
      for (const Vec2& vertex : *other) deepest = std::max(deepest, cross(along, vertex - start));
      least = std::min(least, deepest);
    }
  }
  return least;
}

double distance_to_boundary(const Polygon& polygon, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  const auto see = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      least = std::min(least, distance(Segment{ring[i], ring[(i + 1) % ring.size()]}, point));
    }
  };
  see(polygon.outer);
  for (const Ring& hole : polygon.holes) see(hole);
  return least;
}

// The definition, on a grid of points over the square of 4 m: only ever too small.
double sampled_depth(const Polygon& a, const Polygon& b) {
  double deepest = 0;
  for (double x = -2; x <= 2; x += 0.125) {
    for (double y = -2; y <= 2; y += 0.125) {
      const Vec2 point(x, y);
      if (!contains(a, point) || !contains(b, point)) continue;
      deepest = std::max({deepest, distance_to_boundary(a, point), distance_to_boundary(b, point)});
    }
  }
  return deepest;
}

Polygon random_triangle() {
  Ring ring = {random::point(2), random::point(2), random::point(2)};
  RC_PRE(std::abs(signed_area(ring)) > 0.01);
  return normalized({ring, {}});
}

RC_GTEST_PROP(InteriorsOverlapProperty, OfTrianglesNotWhenTheyCanBeParted, ()) {
  const Polygon a = random_triangle();
  const Polygon b = random_triangle();
  const double depth = separating_depth(a.outer, b.outer);
  // No common point is deeper than the depth of the separating axis.
  if (depth > 0) RC_ASSERT(!interiors_overlap(a, b, 1.001 * depth));
  if (depth <= 0) RC_ASSERT(!interiors_overlap(a, b, tolerance));
  // If they overlap by far more than the tolerance, it is seen.
  if (depth > 100 * tolerance) RC_ASSERT(interiors_overlap(a, b, tolerance));
}

RC_GTEST_PROP(InteriorsOverlapProperty, WhereverASampleIsDeep, ()) {
  const Polygon a = random::polygon();
  const Polygon b = random::transformed(random::polygon(), rotation(random::number(-3, 3)), random::point(3));
  const double depth = sampled_depth(a, b);
  // The factor covers the margin for boundaries that coincide, documented with the function.
  for (const double asked : {1e-6, 1e-3, 0.05}) {
    if (depth > 1.5 * asked) RC_ASSERT(interiors_overlap(a, b, asked));
    RC_ASSERT(interiors_overlap(a, b, asked) == interiors_overlap(b, a, asked));
  }
}

RC_GTEST_PROP(InteriorsOverlapProperty, PiecesOfACutDoNotButEachMeetsTheWhole, ()) {
  const Ring ring = random::star();
  const auto middle = ring.begin() + 2;
  Ring one(ring.begin(), middle + 1);
  one.push_back(Vec2::Zero());
  Ring other(middle, ring.end());
  other.push_back(ring.front());
  other.push_back(Vec2::Zero());
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  const auto moved = [&](const Ring& piece) { return random::transformed({piece, {}}, turn, {100, 200}); };
  RC_ASSERT(!interiors_overlap(moved(one), moved(other), 1e-9));
  RC_ASSERT(interiors_overlap(moved(one), moved(ring), 1e-9));
  RC_ASSERT(interiors_overlap(moved(ring), moved(other), 1e-9));
}

// A star with a hole of its shape, both with so many corners on their sides that they are looked for by an index.
Polygon with_many_corners() {
  const Ring star = random::star();
  const auto divided = [](const Ring& ring) {
    Ring many;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (int part = 0; part < 10; ++part)
        many.push_back(ring[i] + part / 10.0 * (ring[(i + 1) % ring.size()] - ring[i]));
    }
    return many;
  };
  Polygon result{divided(star), {}};
  if (random::integer(0, 1) == 1) result.holes.push_back(divided(random::scaled(star, 0.5)));
  return result;
}

// Stretches of the outline with a point beside it: neighbours that touch, and some that reach in.
Polygon beside(const Polygon& large) {
  const Ring& ring = large.holes.empty() || random::integer(0, 1) == 0 ? large.outer : large.holes.front();
  const auto at = static_cast<std::size_t>(random::integer(0, static_cast<int>(ring.size()) - 1));
  const Vec2& from = ring[at];
  const Vec2& to = ring[(at + 1) % ring.size()];
  const Vec2 aside(to.y() - from.y(), from.x() - to.x());
  return {{from, to, (from + to) / 2 + random::number(0.1, 1) * (random::integer(0, 1) == 0 ? 1 : -1) * aside}, {}};
}

// An index changes how long it takes, and no answer.
RC_GTEST_PROP(OverlapsProperty, ArePairByPairWhatTwoPolygonsSay, ()) {
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  std::vector<Polygon> polygons{with_many_corners(), with_many_corners()};
  polygons[1] = random::transformed(polygons[1], Mat2::Identity(), random::point(3));
  for (int i = 0; i < 6; ++i) polygons.push_back(beside(polygons[static_cast<std::size_t>(i % 2)]));
  for (int i = 0; i < 3; ++i)
    polygons.push_back(random::transformed(random::polygon(), Mat2(0.2 * Mat2::Identity()), random::point(2)));
  std::vector<const Polygon*> all;
  for (Polygon& polygon : polygons) {
    polygon = random::transformed(polygon, turn, {100, 200});
    all.push_back(&polygon);
  }
  Overlaps overlaps(all);
  const int count = static_cast<int>(all.size());
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) {
      if (a == b || defect(*all[static_cast<std::size_t>(a)]) || defect(*all[static_cast<std::size_t>(b)])) continue;
      RC_ASSERT(overlaps.between(a, b, 1e-9) ==
                interiors_overlap(*all[static_cast<std::size_t>(a)], *all[static_cast<std::size_t>(b)], 1e-9));
    }
  }
}

RC_GTEST_PROP(InteriorsOverlapProperty, APlugDoesNotMeetWhatItPlugs, ()) {
  const Ring ring = random::star();
  const Ring hole = random::scaled(ring, 0.5);
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  const Polygon holed = random::transformed({ring, {hole}}, turn, {100, 200});
  const Polygon plug = random::transformed({hole, {}}, turn, {100, 200});
  RC_ASSERT(!interiors_overlap(holed, plug, 1e-9));
  RC_ASSERT(interiors_overlap(random::transformed({ring, {}}, turn, {100, 200}), plug, 1e-9));
}

}  // namespace
}  // namespace dda
