#include "engine/geometry/polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/box.h"
#include "engine/geometry/random_polygon.h"
#include "engine/geometry/rotation.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

// Sums of at most fifty terms, each within a few roundings of its value and none larger than some ten times the
// bounding square's moment: 50 * 10 * 1.1e-16 = 6e-14, with a margin of ten.
constexpr double round_off = 6e-13;

// Integrals about the origin, which may be added.
struct Integrals {
  double area = 0;
  Vec2 first = Vec2::Zero();
  Vec3 second = Vec3::Zero();
};

Integrals about_origin(const AreaMoments& m) {
  const Vec2& c = m.centroid;
  return {m.area, m.area * c,
          Vec3(m.xx + m.area * c.x() * c.x(), m.yy + m.area * c.y() * c.y(), m.xy + m.area * c.x() * c.y())};
}

Integrals operator+(const Integrals& a, const Integrals& b) {
  return {a.area + b.area, a.first + b.first, a.second + b.second};
}

// Another formula than the engine's: A/12 times the sum of (v - c)(v - c)^T over the vertices.
Integrals of_triangle(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 centroid = (a + b + c) / 3;
  AreaMoments m = {cross(b - a, c - a) / 2, centroid, 0, 0, 0};
  for (const Vec2& vertex : {a, b, c}) {
    const Vec2 arm = vertex - centroid;
    m.xx += m.area / 12 * arm.x() * arm.x();
    m.yy += m.area / 12 * arm.y() * arm.y();
    m.xy += m.area / 12 * arm.x() * arm.y();
  }
  return about_origin(m);
}

// Lengths are up to 2 m from the origin: areas up to 16 m2, second moments up to 64 m4.
bool agree(const Integrals& a, const Integrals& b) {
  return std::abs(a.area - b.area) <= 16 * round_off && (a.first - b.first).norm() <= 32 * round_off &&
         (a.second - b.second).norm() <= 64 * round_off;
}

bool agree(const AreaMoments& a, const AreaMoments& b) {
  return std::abs(a.area - b.area) <= 16 * round_off && (a.centroid - b.centroid).norm() <= 32 * round_off &&
         (Vec3(a.xx, a.yy, a.xy) - Vec3(b.xx, b.yy, b.xy)).norm() <= 64 * round_off;
}

void expect_moments(const Polygon& polygon, const AreaMoments& expected) {
  const AreaMoments m = area_moments(polygon);
  const double length = std::sqrt(expected.area);
  EXPECT_NEAR(m.area, expected.area, round_off * expected.area);
  EXPECT_NEAR(m.centroid.x(), expected.centroid.x(), round_off * length);
  EXPECT_NEAR(m.centroid.y(), expected.centroid.y(), round_off * length);
  EXPECT_NEAR(m.xx, expected.xx, round_off * (expected.xx + expected.yy));
  EXPECT_NEAR(m.yy, expected.yy, round_off * (expected.xx + expected.yy));
  EXPECT_NEAR(m.xy, expected.xy, round_off * (expected.xx + expected.yy));
}

Ring rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring octagon(double radius) {
  Ring ring;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::numbers::pi / 4;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

const Ring l_shape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(AreaMoments, Square) { expect_moments({rectangle(0, 0, 1, 1), {}}, {1, {0.5, 0.5}, 1. / 12, 1. / 12, 0}); }

TEST(AreaMoments, Rectangle) {
  expect_moments({rectangle(-1, 2, 3, 5), {}}, {12, {1, 3.5}, 4. * 4 * 4 * 3 / 12, 3. * 3 * 3 * 4 / 12, 0});
}

TEST(AreaMoments, RightTriangle) {
  expect_moments({{{0, 0}, {3, 0}, {0, 2}}, {}}, {3, {1, 2. / 3}, 27. * 2 / 36, 3. * 8 / 36, -9. * 4 / 72});
}

TEST(AreaMoments, LShape) { expect_moments({l_shape, {}}, {3, {5. / 6, 5. / 6}, 11. / 12, 11. / 12, -1. / 3}); }

TEST(AreaMoments, SquareWithSquareHole) {
  expect_moments({rectangle(0, 0, 4, 4), {rectangle(1, 1, 3, 3)}}, {12, {2, 2}, 240. / 12, 240. / 12, 0});
}

TEST(AreaMoments, SquareWithHoleOffCentre) {
  // Centroid (16*2 - 1*1.5) / 15; parallel axes for the two squares.
  const double c = 30.5 / 15;
  const double second = 256. / 12 + 16 * (2 - c) * (2 - c) - 1. / 12 - (1.5 - c) * (1.5 - c);
  const double mixed = 16 * (2 - c) * (2 - c) - (1.5 - c) * (1.5 - c);
  expect_moments({rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2)}}, {15, {c, c}, second, second, mixed});
}

TEST(AreaMoments, RegularOctagonRing) {
  // A regular octagon of circumradius R has area 2 sqrt(2) R^2, second moment R^4 (2 sqrt(2) + 1) / 6 about any axis.
  const double second = (16 - 1) * (2 * std::numbers::sqrt2 + 1) / 6;
  expect_moments({octagon(2), {octagon(1)}}, {2 * std::numbers::sqrt2 * (4 - 1), {0, 0}, second, second, 0});
}

TEST(AreaMoments, SlenderBarKeepsItsSmallMoment) {
  // 1000 m by 0.5 m: the small moment to its own relative precision, although the other is four million times larger.
  const AreaMoments m = area_moments({rectangle(0, 0, 1000, 0.5), {}});
  EXPECT_NEAR(m.yy, 1000 * 0.125 / 12, 1e-14 * m.yy);
}

TEST(AreaMoments, AMillionMetresAwayNothingIsLost) {
  const Polygon near = {l_shape, {rectangle(0.25, 0.25, 0.75, 0.5)}};
  const AreaMoments at_origin = area_moments(near);
  const AreaMoments far = area_moments(random::transformed(near, Mat2::Identity(), {1e6, -1e6}));
  EXPECT_EQ(far.area, at_origin.area);
  EXPECT_EQ(far.xx, at_origin.xx);
  EXPECT_EQ(far.yy, at_origin.yy);
  EXPECT_EQ(far.xy, at_origin.xy);
  EXPECT_EQ(far.centroid, at_origin.centroid + Vec2(1e6, -1e6));
}

RC_GTEST_PROP(AreaMomentsProperty, TranslationChangesOnlyTheCentroid, ()) {
  const Polygon polygon = random::polygon();
  const Vec2 shift(random::integer(-4'000'000, 4'000'000), random::integer(-4'000'000, 4'000'000));
  const AreaMoments before = area_moments(polygon);
  const AreaMoments after = area_moments(random::transformed(polygon, Mat2::Identity(), shift));
  // Differences of vertices are the same doubles before and after, so the integrals are too.
  RC_ASSERT(after.area == before.area);
  RC_ASSERT(after.xx == before.xx);
  RC_ASSERT(after.yy == before.yy);
  RC_ASSERT(after.xy == before.xy);
  // The spacing of doubles at 4e6 is 4.7e-10 m; the sum of two terms is rounded once or twice.
  RC_ASSERT((after.centroid - shift - before.centroid).norm() <= 1e-9);
}

RC_GTEST_PROP(AreaMomentsProperty, RotationTurnsTheTensor, ()) {
  const Polygon polygon = random::polygon();
  const double angle = random::number(-3.2, 3.2);
  const AreaMoments before = area_moments(polygon);
  const Vec3 second = rotate_stress({before.xx, before.yy, before.xy}, angle);
  const AreaMoments expected = {before.area, rotation(angle) * before.centroid, second[0], second[1], second[2]};
  RC_ASSERT(agree(area_moments(random::transformed(polygon, rotation(angle), Vec2::Zero())), expected));
}

RC_GTEST_PROP(AreaMomentsProperty, TheFirstVertexAndTheOrientationDoNotMatter, ()) {
  Polygon polygon = random::polygon();
  const AreaMoments before = area_moments(polygon);
  std::rotate(polygon.outer.begin(), polygon.outer.begin() + random::integer(0, 3), polygon.outer.end());
  if (*rc::gen::arbitrary<bool>()) std::reverse(polygon.outer.begin(), polygon.outer.end());
  for (Ring& hole : polygon.holes) {
    if (*rc::gen::arbitrary<bool>()) std::reverse(hole.begin(), hole.end());
  }
  RC_ASSERT(agree(area_moments(polygon), before));
}

RC_GTEST_PROP(AreaMomentsProperty, IsTheSumOfItsTriangles, ()) {
  const Ring ring = random::star();
  Integrals sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum = sum + of_triangle(Vec2::Zero(), ring[i], ring[(i + 1) % ring.size()]);
  }
  RC_ASSERT(agree(about_origin(area_moments({ring, {}})), sum));
}

RC_GTEST_PROP(AreaMomentsProperty, CuttingAdds, ()) {
  const Ring ring = random::star();
  const int count = static_cast<int>(ring.size());
  const int from = random::integer(0, count - 3);
  const int to = random::integer(from + 2, std::min(from, 1) + count - 2);
  // The cut runs from one vertex through the origin, which sees the whole polygon, to another.
  Ring one(ring.begin() + from, ring.begin() + to + 1);
  one.push_back(Vec2::Zero());
  Ring other(ring.begin() + to, ring.end());
  other.insert(other.end(), ring.begin(), ring.begin() + from + 1);
  other.push_back(Vec2::Zero());
  RC_ASSERT(agree(about_origin(area_moments({one, {}})) + about_origin(area_moments({other, {}})),
                  about_origin(area_moments({ring, {}}))));
}

RC_GTEST_PROP(AreaMomentsProperty, HolesSubtract, ()) {
  const Ring ring = random::star();
  const Ring hole = random::scaled(ring, 0.5);
  const Integrals with_plug = about_origin(area_moments({ring, {hole}})) + about_origin(area_moments({hole, {}}));
  RC_ASSERT(agree(with_plug, about_origin(area_moments({ring, {}}))));
}

TEST(Polygon, NormalizedTurnsRingsAndKeepsFirstVertices) {
  Ring clockwise = rectangle(0, 0, 4, 4);
  std::reverse(clockwise.begin(), clockwise.end());
  const Polygon polygon = normalized({clockwise, {rectangle(1, 1, 2, 2)}});
  EXPECT_EQ(signed_area(polygon.outer), 16);
  EXPECT_EQ(signed_area(polygon.holes[0]), -1);
  EXPECT_EQ(polygon.outer[0], clockwise[0]);
  EXPECT_EQ(polygon.holes[0][0], Vec2(1, 1));
  const Polygon again = normalized(polygon);
  EXPECT_EQ(again.outer, polygon.outer);
  EXPECT_EQ(again.holes, polygon.holes);
}

TEST(Polygon, LocatesPoints) {
  const Polygon polygon = {l_shape, {rectangle(0.25, 0.25, 0.75, 0.75)}};
  EXPECT_EQ(locate(polygon, {1.5, 0.5}), Location::inside);
  EXPECT_EQ(locate(polygon, {1.5, 1.5}), Location::outside);
  EXPECT_EQ(locate(polygon, {0.5, 0.5}), Location::outside);
  EXPECT_EQ(locate(polygon, {1, 1}), Location::boundary);
  EXPECT_EQ(locate(polygon, {0.5, 0.25}), Location::boundary);
  EXPECT_EQ(locate(polygon, {1.5, 1.01}, 0.02), Location::boundary);
  EXPECT_TRUE(contains(polygon, {0, 1}));
  EXPECT_FALSE(contains(polygon, {0.5, 0.5}));
  EXPECT_FALSE(contains(polygon, {-1, 1}));  // the ray from here runs along an edge
}

// Winding angle seen from the point: a turn inside, none outside.
double winding(const Ring& ring, const Vec2& point) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - point;
    const Vec2 b = ring[(i + 1) % ring.size()] - point;
    sum += std::atan2(cross(a, b), a.dot(b));
  }
  return sum / (2 * std::numbers::pi);
}

RC_GTEST_PROP(PolygonProperty, ContainsAgreesWithTheWindingNumber, ()) {
  const Polygon polygon = random::polygon();
  const Vec2 point = random::point(2);
  RC_PRE(locate(polygon, point, 1e-9) != Location::boundary);
  double turns = winding(polygon.outer, point);
  for (const Ring& hole : polygon.holes) turns -= winding(hole, point);
  RC_ASSERT(contains(polygon, point) == (turns > 0.5));
}

}  // namespace
}  // namespace dda
