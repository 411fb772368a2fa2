#include "engine/contact/vertex_contact.h"
#include "engine/contact/narrow_phase.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/entrance_cover.h"
#include "engine/geometry/random_polygon.h"

namespace dda {
namespace {

constexpr double reach = 0.02;
constexpr double depth = 0.1;
constexpr double corner = 1e-9;

// Blocks as given, wherever they are: finish_model would refuse overlaps.
Outlines outlines_of(const std::vector<Polygon>& shapes) {
  Model model;
  for (const Polygon& shape : shapes) {
    model.blocks.emplace_back().shape = shape;
    model.blocks.back().moments = area_moments(shape);
  }
  return make_outlines(model, initial_state(model));
}

std::vector<VertexContact> contacts_of(const Outlines& outlines) {
  std::vector<VertexContact> found;
  NarrowPhase(outlines).find(0, 1, {reach, depth, corner}, found);
  std::sort(found.begin(), found.end());
  return found;
}

Polygon box(double left, double bottom, double width, double height, double angle = 0) {
  const Vec2 middle(left + width / 2, bottom + height / 2);
  const Polygon centred{box_ring(-width / 2, -height / 2, width / 2, height / 2), {}};
  return random::transformed(centred, rotation(angle), middle);
}

std::vector<VertexContact> contacts_of(const std::vector<Polygon>& shapes) { return contacts_of(outlines_of(shapes)); }

// ---- Particular positions.

// Vertical gaps of blocks that lie on each other; gaps of 1e-9 m count as none.
const std::vector<double> small_gaps = {1e-3, 1e-9, 0, -2e-9, -1e-7, -1e-5, -1e-4};

TEST(VertexContact, AlignedBoxesTouchInTwoCorners) {
  for (const double gap : small_gaps) {
    for (const double width : {1.0, 1.0 + 1e-15, 1 - 1e-9, 1 + 1e-8}) {
      for (const double angle : {0.0, 1e-12, -1e-9, 1e-6, -1e-6}) {
        const std::vector<VertexContact> found = contacts_of({box(0, 0, 1, 1), box(0, 1 + gap, width, 1, angle)});
        EXPECT_EQ(found.size(), 2U) << gap << ' ' << width << ' ' << angle;
        for (const VertexContact& contact : found) {
          EXPECT_NEAR(std::abs(contact.normal.y()), 1, 1e-11);
          EXPECT_NEAR(contact.gap, gap, 1e-6);
        }
      }
    }
  }
}

// Across the whole edge and past both its corners. Where less than the corner distance is left of the common stretch,
// its ends are one corner that meets another.
TEST(VertexContact, ABoxThatSlidesAcrossAnotherHasTwo) {
  for (const double gap : small_gaps) {
    for (const double angle : {0.0, 1e-7, -1e-7}) {
      for (int step = -2200; step <= 3200; ++step) {
        for (const double beside : {0.0, 1e-12, -3e-5}) {
          const double left = 1e-3 * step + beside;
          const double common = std::min(left + 1, 3.0) - std::max(left, 0.0);
          const auto found = contacts_of({box(0, 0, 3, 1), box(left, 1 + gap, 1, 0.5, angle)});
          // A box that overlaps by less than it has sunk in leaves by the side just as well.
          const double unsure = corner + 2 * std::abs(gap);
          ASSERT_LE(found.size(), std::abs(common) < unsure ? 3U : 2U) << left << ' ' << gap << ' ' << angle;
          if (common < -unsure) {
            for (const VertexContact& contact : found) ASSERT_GT(contact.gap, 0) << left << ' ' << gap << ' ' << angle;
          }
          if (common < unsure) continue;
          ASSERT_EQ(found.size(), 2U) << left << ' ' << gap << ' ' << angle;
          for (const VertexContact& contact : found) ASSERT_GT(std::abs(contact.normal.y()), 0.99);
        }
      }
    }
  }
}

TEST(VertexContact, CornerOnEdgeIsOne) {
  const double quarter = std::numbers::pi / 4;
  const double half_diagonal = std::numbers::sqrt2 / 2;
  for (const double gap : {0.01, 0.0, -0.01}) {
    const std::vector<VertexContact> found =
        contacts_of({box(-2, -1, 4, 1), box(0.1, half_diagonal - 0.5 + gap, 1, 1, quarter)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].edge_block, 0);
    EXPECT_EQ(found[0].vertex_block, 1);
    EXPECT_NEAR(found[0].gap, gap, 1e-15);
    EXPECT_NEAR((found[0].normal - Vec2(0, 1)).norm(), 0, 1e-15);
  }
}

// A box on the corner of a box: neither face is the one rather than the other, so both are, whichever way the scene is
// numbered.
TEST(VertexContact, CornerOnCornerMeetsBothFaces) {
  for (const auto& boxes : {std::vector{box(0, 0, 1, 1), box(1, 1, 1, 1)}, {box(1, 1, 1, 1), box(0, 0, 1, 1)}}) {
    const auto found = contacts_of(boxes);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].normal.dot(found[1].normal), 0, 1e-12);
  }
  // Tip on tip.
  const double half_diagonal = std::numbers::sqrt2 / 2;
  const auto found = contacts_of({box(-0.5, -0.5 - half_diagonal, 1, 1, std::numbers::pi / 4),
                                  box(-0.5, -0.5 + half_diagonal, 1, 1, std::numbers::pi / 4)});
  EXPECT_LE(found.size(), 2U);
}

// A box stands on a step, its side in line with the step's riser. Round-off of what was drawn lets the two lines cross,
// and behind the line of the upper tread is the box by the height of the riser: it has not come in through that tread.
// A box above another, flush with its side, comes down past it: it goes on touching the side and meets no top. Where it
// comes down a little askew, over the other, its top is what it meets.
TEST(VertexContact, ABoxThatFallsFlushBesideAnotherMeetsItsSide) {
  for (const double apart : {0.0, 1e-16, 5e-10, -5e-10}) {
    Outlines outlines = outlines_of({box(-1, 0, 1, 1), box(apart, 1.01, 1, 1)});
    for (const double aside : {0.0, -1e-4}) {
      for (int vertex = 4; vertex < 8; ++vertex) outlines.coming[static_cast<std::size_t>(vertex)] = {aside, -0.02};
      const std::vector<VertexContact> found = contacts_of(outlines);
      ASSERT_FALSE(found.empty());
      for (const VertexContact& contact : found)
        EXPECT_NEAR(std::abs(contact.normal.x()), aside == 0 ? 1 : 0, 1e-12) << apart << " " << aside;
    }
  }
}

// A hexagon that falls past a corner with its widest place: the edge below that corner closes in the step and has gone
// past its end by then. Where the widest place is over the other box, that edge is met.
TEST(VertexContact, AHexagonThatFallsPastACornerMeetsItsSide) {
  for (const double apart : {1e-6, 1e-9, 0.0, -1e-4}) {
    const double left = apart, half = 0.5, side = 0.2;
    const Polygon hexagon{{{left, 1.005},
                           {left + side, 1.005 - half},
                           {left + 2 * side, 1.005 - half},
                           {left + 3 * side, 1.005},
                           {left + 2 * side, 1.005 + half},
                           {left + side, 1.005 + half}},
                          {}};
    Outlines outlines = outlines_of({box(-1, 0, 1, 1), hexagon});
    for (std::size_t vertex = 4; vertex < 10; ++vertex) outlines.coming[vertex] = {0, -0.02};
    const std::vector<VertexContact> found = contacts_of(outlines);
    ASSERT_EQ(found.size(), 1U) << apart;
    EXPECT_NEAR(std::abs(found[0].normal.x()), apart < -1e-8 ? 0.5 / std::hypot(0.5, 0.2) : 1, 1e-12) << apart;
  }
}

TEST(VertexContact, FacesInLineThatCrossByRoundOffAreNotAWayIn) {
  for (const double riser : {0.02, 0.05, 0.09}) {
    const Polygon step{{{-1, -2}, {2, -2}, {2, riser}, {1, riser}, {1, 0}, {-1, 0}}, {}};
    for (const double tilt : {-1e-10, 0.0, 1e-10}) {
      for (const double beside : {-1e-10, 0.0, 1e-10}) {
        const Polygon column{{{0, 0}, {1 + beside, 0}, {1 + tilt, 2}, {0, 2}}, {}};
        for (const VertexContact& contact : contacts_of({step, column}))
          EXPECT_GT(contact.gap, -corner) << riser << ' ' << tilt << ' ' << beside;
      }
    }
  }
}

// An L whose notch holds a box: the box' corner meets both edges of the notch, the notch's own vertex meets nothing.
TEST(VertexContact, ReflexCornersNeverEnter) {
  const Polygon angle{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {}};
  constexpr int notch = 3;
  for (const double gap : {1e-3, 0.0, -1e-9, -1e-7, -1e-5}) {
    const std::vector<VertexContact> found = contacts_of({angle, box(1 + gap, 1 + gap, 0.5, 0.5)});
    int floor = 0;
    int wall = 0;
    for (const VertexContact& contact : found) {
      EXPECT_NE(contact.vertex, notch);
      EXPECT_EQ(contact.edge_block, 0);
      EXPECT_NEAR(contact.gap, gap, 1e-15);
      ++(contact.normal.y() > 0.5 ? floor : wall);
    }
    EXPECT_EQ(floor, 2) << gap;
    EXPECT_EQ(wall, 2) << gap;
  }
}

// A box on a step of a stair: its corner in the notch lies below the next step's line, but behind that step's riser.
TEST(VertexContact, ABoxOnAStepMeetsNoOtherStep) {
  const Polygon stair{{{0, -1}, {3, -1}, {3, 0.05}, {1, 0.05}, {1, 0}, {0, 0}}, {}};
  for (const double gap : {1e-3, 1e-9, 0.0, -1e-9, -1e-7, -1e-5, -1e-4}) {
    const auto found = contacts_of({stair, box(0.5 - gap, gap, 0.5, 1)});
    EXPECT_EQ(found.size(), 4U) << gap;  // two on the tread, two on the riser
    for (const VertexContact& contact : found) EXPECT_NEAR(contact.gap, gap, 1e-15);
  }
}

// A vertex shallow under one edge of a convex corner and deep behind the other has come in through the first.
TEST(VertexContact, EntersThroughTheNearerEdge) {
  const auto found = contacts_of({box(0, 0, 1, 1), box(0.95, 1 - 1e-3, 1, 1)});
  ASSERT_EQ(found.size(), 2U);
  for (const VertexContact& contact : found) EXPECT_NEAR(contact.gap, -1e-3, 1e-15);
}

// ---- Random scenes against an oracle.

// The same question asked in polar form of complex numbers: an edge pulled onto the positive real axis has its block
// above (left), so a vertex at w has its gap -Im w, and its own edges must point below, all but the slack.
struct Expected {
  int edge, vertex;
  double gap;
  double margin;  // m or rad, by which it is one (positive) or is none
};

using Complex = std::complex<double>;
Complex complex_of(const Vec2& v) { return {v.x(), v.y()}; }

double smallest(std::initializer_list<double> values) { return std::min(values); }

Expected expectation(const Outlines& outlines, int vertex, int edge) {
  const auto place = [&](int i) { return complex_of(outlines.current[static_cast<std::size_t>(i)]); };
  const auto next = [&](int i) { return outlines.next[static_cast<std::size_t>(i)]; };
  const auto previous = [&](int i) { return outlines.previous[static_cast<std::size_t>(i)]; };
  const Complex origin = place(edge);
  const double length = std::abs(place(next(edge)) - origin);
  const Complex turn = std::polar(1.0, -std::arg(place(next(edge)) - origin));
  const Complex w = turn * (place(vertex) - origin);
  const auto dip = [&](int neighbour) {
    return std::asin(std::clamp(
        (turn * (place(neighbour) - place(vertex)) / std::abs(place(neighbour) - place(vertex))).imag(), -1.0, 1.0));
  };
  const double slack = std::asin(entrance_slack);
  const double gap = -w.imag();
  return {edge, vertex, gap,
          smallest({w.real(), length - w.real(), reach - gap, gap + depth, slack - dip(next(vertex)),
                    slack - dip(previous(vertex))})};
}

std::vector<Expected> expectations(const Outlines& outlines) {
  std::vector<Expected> all;
  const int first_of_b = outlines.starts[1];
  const int end = outlines.starts[2];
  for (int i = 0; i < first_of_b; ++i) {
    for (int j = first_of_b; j < end; ++j) {
      all.push_back(expectation(outlines, i, j));
      all.push_back(expectation(outlines, j, i));
    }
  }
  return all;
}

// B's edge laid against A's, nearly antiparallel, at a random place along it and a random small gap: where contacts
// are.
std::vector<Polygon> touching_pair() {
  const Ring a = random::star();
  const Ring b = random::star();
  const auto i = static_cast<std::size_t>(random::integer(0, static_cast<int>(a.size()) - 1));
  const auto j = static_cast<std::size_t>(random::integer(0, static_cast<int>(b.size()) - 1));
  const Vec2 along_a = a[(i + 1) % a.size()] - a[i];
  const Vec2 along_b = b[(j + 1) % b.size()] - b[j];
  const double tilt = random::integer(0, 2) == 0 ? random::number(-1, 1) : random::number(-0.02, 0.02);
  const Complex turn = -complex_of(along_a) / complex_of(along_b);
  const Mat2 matrix = rotation(std::arg(turn) + tilt);
  const Vec2 outward = Vec2(along_a.y(), -along_a.x()).normalized();
  const Vec2 target = a[i] + random::number(-0.2, 1.2) * along_a + random::number(-0.03, 0.025) * outward;
  return {{a, {}}, random::transformed({b, {}}, matrix, target - matrix * b[j])};
}

// Whether the end of the edge that is nearer to the vertex turns to the right.
bool is_by_a_notch(const Outlines& outlines, const VertexContact& contact) {
  const auto place = [&](int i) { return complex_of(outlines.current[static_cast<std::size_t>(i)]); };
  const int start = contact.edge;
  const int end = outlines.next[static_cast<std::size_t>(start)];
  const bool nearer_start =
      std::abs(place(contact.vertex) - place(start)) < std::abs(place(contact.vertex) - place(end));
  const int middle = nearer_start ? start : end;
  const int before = outlines.previous[static_cast<std::size_t>(middle)];
  const int after = outlines.next[static_cast<std::size_t>(middle)];
  return std::arg((place(after) - place(middle)) / (place(middle) - place(before))) < 0;
}

// A vertex on the far side of a thin part of the block is behind the line of an edge but nowhere near.
bool is_far(const Outlines& outlines, const Expected& expected) {
  const std::size_t edge_block = expected.edge < outlines.starts[1] ? 0 : 1;
  const Box near = expanded(outlines.boxes[edge_block], reach - 1e-9);
  return !overlap(near, expanded(Box{}, outlines.current[static_cast<std::size_t>(expected.vertex)]));
}

// A vertex whose own faces look the way the edge looks lies behind the edge's block: it cannot come in through the
// edge.
bool looks_the_same_way(const Outlines& outlines, const Expected& expected) {
  const auto normal = [&](int edge) {
    const Vec2 along = outlines.along(edge).normalized();
    return Vec2(along.y(), -along.x());
  };
  const int before = outlines.previous[static_cast<std::size_t>(expected.vertex)];
  return normal(expected.edge).dot(normal(expected.vertex) + normal(before)) >= 0;
}

bool same(const VertexContact& contact, const Expected& expected) {
  return contact.edge == expected.edge && contact.vertex == expected.vertex;
}

RC_GTEST_PROP(VertexContactProperty, OnlyWhatTheOracleAllowsAndNoneTwice, ()) {
  const Outlines outlines = outlines_of(touching_pair());
  const std::vector<VertexContact> found = contacts_of(outlines);
  RC_CLASSIFY(!found.empty());
  const std::vector<Expected> expected = expectations(outlines);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto match =
        std::find_if(expected.begin(), expected.end(), [&](const Expected& e) { return same(found[i], e); });
    RC_ASSERT(match != expected.end());
    RC_ASSERT(std::abs(match->gap - found[i].gap) < 1e-12);
    // A vertex pressed into a notch lies beyond the ends of both edges there, by as much as it is pressed in. One that
    // is not pressed in may come over an end in the next step.
    const bool may_be_beyond = found[i].gap >= 0 || is_by_a_notch(outlines, found[i]);
    RC_ASSERT(match->margin > -1e-9 - (may_be_beyond ? reach : entrance_slack * -found[i].gap));
    if (i > 0) RC_ASSERT(found[i - 1] < found[i]);
  }
}

// What the oracle is sure of is found, unless the same vertex is nearer to another edge of the same block. (Of gaps
// that are closed contact_population_test.cpp judges.)
RC_GTEST_PROP(VertexContactProperty, EveryContactOfTheOracleIsFoundOrANearerOne, ()) {
  const Outlines outlines = outlines_of(touching_pair());
  const std::vector<VertexContact> found = contacts_of(outlines);
  for (const Expected& expected : expectations(outlines)) {
    if (expected.margin < 1e-9 || expected.gap < 0 || is_far(outlines, expected)) continue;
    if (looks_the_same_way(outlines, expected)) continue;
    const bool covered = std::any_of(found.begin(), found.end(), [&](const VertexContact& contact) {
      const bool same_vertex = contact.vertex == expected.vertex;
      const Vec2 apart = outlines.current[static_cast<std::size_t>(contact.vertex)] -
                         outlines.current[static_cast<std::size_t>(expected.vertex)];
      const bool corners_meet = apart.norm() <= 2 * corner + depth;
      return same(contact, expected) || ((same_vertex || corners_meet) && contact.gap >= expected.gap);
    });
    RC_ASSERT(covered);
  }
}

// A pentagon with a base of this width and a notch opposite it, right way up.
Polygon notched(double left, double base, double width) {
  const double right = left + width;
  return {{{left, base},
           {right, base},
           {right - 0.2 * width, base + 0.6},
           {left + width / 2, base + 0.3},
           {left + 0.2 * width, base + 0.6}},
          {}};
}

// Antiparallel edges at a small gap: both ends of their common stretch are contacts where the vertex there is convex.
RC_GTEST_PROP(VertexContactProperty, EndsOfACommonStretch, ()) {
  const double lower_width = random::number(0.3, 2);
  const double width = random::number(0.3, 2);
  const double left = random::number(-width + 0.001, lower_width - 0.001);
  const double gap = random::number(-1e-3, 0.015);
  const double common = std::min(left + width, lower_width) - std::max(left, 0.0);
  RC_PRE(common > 4e-3);
  const Mat2 matrix = rotation(random::number(-3, 3));
  const Polygon lower = random::transformed(notched(-lower_width, 0, lower_width), -Mat2::Identity(), Vec2::Zero());
  const Polygon upper = notched(left, gap, width);
  const auto found =
      contacts_of({random::transformed(lower, matrix, {1, 2}), random::transformed(upper, matrix, {1, 2})});
  RC_ASSERT(found.size() == 2);
  for (const VertexContact& contact : found) RC_ASSERT(std::abs(contact.gap - gap) < 1e-14);
}

}  // namespace
}  // namespace dda
