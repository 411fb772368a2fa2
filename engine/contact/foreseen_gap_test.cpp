#include "engine/contact/foreseen_gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

constexpr double dt = 0.5;  // s

Vec6 rigid(double x, double y, double turn) { return (Vec6() << x, y, turn, 0, 0, 0).finished(); }

// An edge of block a that a vertex of block b slides along, while both move as rigid bodies by these increments in one
// step.
struct Motion {
  Vec6 of_a = rigid(0.2, -0.1, 0.3);
  Vec6 of_b = rigid(0.9, 0.4, -0.7);
  Vec2 foot{1.5, 0.2};      // m, from the centroid of a to a point of its edge
  Vec2 normal{0.6, 0.8};    // of that edge
  Vec2 centroid_b{2, 1.3};  // m, from that of a
  Vec2 vertex{-0.7, -0.9};  // m, from the centroid of b

  [[nodiscard]] Motion times(double factor) const {
    Motion less = *this;
    less.of_a *= factor;
    less.of_b *= factor;
    return less;
  }
};

struct Place {
  Vec2 centroid_a, centroid_b, foot, vertex, normal;
};

// At the share s of the step.
Place at(const Motion& motion, double s) {
  const Mat2 turn_a = rotation(s * motion.of_a(2));
  const Vec2 a = s * motion.of_a.head<2>();
  const Vec2 b = motion.centroid_b + s * motion.of_b.head<2>();
  return {a, b, a + turn_a * motion.foot, b + rotation(s * motion.of_b(2)) * motion.vertex, turn_a * motion.normal};
}

double gap(const Motion& motion, double s) {
  const Place place = at(motion, s);
  return place.normal.dot(place.vertex - place.foot);
}

// One contact whose forces act where the blocks are at the share s, at a gap of `gap`.
ContactSet contact_at(const Motion& motion, double s, double gap) {
  const Place place = at(motion, s);
  ContactSet contacts;
  InterfaceElement& element = contacts.elements.edit().emplace_back();
  element.block_b = 1;
  const Mat2 axes = (Mat2() << place.normal.x(), place.normal.y(), -place.normal.y(), place.normal.x()).finished();
  element.rows_a.setZero();
  element.rows_b.setZero();
  element.rows_a.topRows<2>() = -axes * displacement_rows(place.vertex - place.centroid_a);
  element.rows_b.topRows<2>() = axes * displacement_rows(place.vertex - place.centroid_b);
  contacts.states.emplace_back().gap(0) = gap;
  return contacts;
}

// The gaps with which the step begins.
Vec2 foreseen(const Motion& motion, double s, double gap) {
  ContactSet contacts = contact_at(motion, s, gap);
  foresee_gaps({motion.of_a / dt, motion.of_b / dt}, dt, s, contacts);
  return contacts.states[0].gap.head<2>();
}

// How far the vertex slides along the edge in the step: the sum of very many small slips, each along the edge where it
// then is.
double slid(const Motion& motion) {
  constexpr int parts = 2000;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const Vec2 along = rotation((i + 0.5) / parts * motion.of_a(2)) * Vec2(-motion.normal.y(), motion.normal.x());
    // The point of block a where the vertex is half-way, seen from its centroid and turned back with the block.
    const Place half = at(motion, (i + 0.5) / parts);
    const Vec2 seat = rotation(-(i + 0.5) / parts * motion.of_a(2)) * (half.vertex - half.centroid_a);
    const auto apart = [&](double s) {
      const Place place = at(motion, s);
      return Vec2(place.vertex - place.centroid_a - rotation(s * motion.of_a(2)) * seat);
    };
    sum += along.dot(apart((i + 1.0) / parts) - apart(static_cast<double>(i) / parts));
  }
  return sum;
}

// By how much the gaps at the end of the step are missed: normal and shear.
Vec2 misses(const Motion& motion, double s) {
  constexpr double start = -10;  // so deep that nothing opens
  const InterfaceElement element = contact_at(motion, s, start).elements[0];
  const Vec2 found = foreseen(motion, s, start) - Vec2(start, 0) +
                     (element.rows_a * motion.of_a + element.rows_b * motion.of_b).head<2>();
  return (found - Vec2(gap(motion, 1) - gap(motion, 0), slid(motion))).cwiseAbs();
}

TEST(ForeseenGap, MakesGapsOfTheStepRightToThirdOrderWhereverForcesAct) {
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    const Vec2 coarse = misses(Motion().times(1e-2), s);
    const Vec2 fine = misses(Motion().times(5e-3), s);
    for (const int row : {0, 1}) EXPECT_NEAR(std::log2(coarse(row) / fine(row)), 3, 0.05) << s << ", row " << row;
  }
}

TEST(ForeseenGap, NeitherOpensNorClosesAContact) {
  const Motion closing = Motion().times(0.1);
  const double by = foreseen(closing, 1, -10)(0) + 10;
  ASSERT_NE(by, 0);
  const double other_way = foreseen(closing, 0, -10)(0) + 10;
  ASSERT_LT(by * other_way, 0);
  for (const double s : {0.0, 1.0}) {
    EXPECT_GE(foreseen(closing, s, 0)(0), 0) << s;  // a gap of 0 does not press
    EXPECT_GE(foreseen(closing, s, 1e-9)(0), 0) << s;
    EXPECT_LE(foreseen(closing, s, -1e-9)(0), 0) << s;
  }
}

TEST(ForeseenGap, LeavesTheShearOfWhatIsOpenAlone) {
  const Motion motion = Motion().times(0.1);
  ContactSet contacts = contact_at(motion, 1, 1e-3);
  contacts.states[0].status[0] = ContactStatus::open;
  foresee_gaps({motion.of_a / dt, motion.of_b / dt}, dt, 1, contacts);
  EXPECT_EQ(contacts.states[0].gap(1), 0);
}

}  // namespace
}  // namespace dda
