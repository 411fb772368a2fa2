// The contacts of random pairs of blocks, cut from one piece and moved a little, against what the motion says.
//
// The judge knows nothing of covers. One block has been moved by a known small motion from where the two fitted
// exactly, so moving it back separates them, and no point of either is deeper in the other than the motion was long.
// Contacts are right if no gap is deeper than that; if the smallest rigid motion that closes none of them (a quadratic
// program) exists and is hardly larger than the one that was made; and if the blocks then do not overlap, by clipping
// their triangles with each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/narrow_phase.h"
#include "engine/contact/vertex_contact.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/random_polygon.h"
#include "engine/geometry/triangulate.h"

namespace dda {
namespace {

// ---- Overlap by clipping.

std::vector<Ring> triangles_of(const Polygon& polygon) {
  Ring vertices = polygon.outer;
  for (const Ring& hole : polygon.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
  std::vector<Ring> triangles;
  for (const Triangle& corners : triangulate(polygon)) {
    Ring& ring = triangles.emplace_back();
    for (const int corner : corners) ring.push_back(vertices[static_cast<std::size_t>(corner)]);
  }
  return triangles;
}

// The part of a convex ring on the left of a line (Sutherland and Hodgman).
Ring left_of(const Ring& ring, const Vec2& from, const Vec2& to) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& start = ring[i];
    const Vec2& end = ring[(i + 1) % ring.size()];
    const double side = cross(to - from, start - from);
    const double end_side = cross(to - from, end - from);
    if (side >= 0) kept.push_back(start);
    if (side * end_side < 0) kept.emplace_back(start + side / (side - end_side) * (end - start));
  }
  return kept;
}

double distance_from_outline(const Polygon& polygon, const Vec2& point) {
  double least = 1e300;
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, distance({ring[i], ring[(i + 1) % ring.size()]}, point));
  };
  look(polygon.outer);
  for (const Ring& hole : polygon.holes) look(hole);
  return least;
}

// How far the middle of some common part is inside both blocks, m.
double common_depth(const Polygon& a, const Polygon& b) {
  double deepest = 0;
  for (const Ring& of_a : triangles_of(a))
    for (const Ring& of_b : triangles_of(b)) {
      Ring common = of_a;
      for (std::size_t i = 0; i < 3 && common.size() > 2; ++i) common = left_of(common, of_b[i], of_b[(i + 1) % 3]);
      if (common.size() < 3) continue;
      Vec2 middle = Vec2::Zero();
      for (const Vec2& vertex : common) middle += vertex / static_cast<double>(common.size());
      if (!contains(a, middle) || !contains(b, middle)) continue;  // of a triangle without area
      deepest = std::max(deepest, std::min(distance_from_outline(a, middle), distance_from_outline(b, middle)));
    }
  return deepest;
}

// ---- The smallest motion that opens all gaps.

struct Motion {
  Vec2 shift = Vec2::Zero();  // m
  double turn = 0;            // m: angle times `arm`
  bool exists = true;

  [[nodiscard]] double size() const { return std::hypot(shift.norm(), turn); }
};

struct Body {
  Vec2 centre;
  double arm;  // m, half of its diameter

  // What gaps leave out of a turn, m.
  [[nodiscard]] double second_order(const Motion& motion) const { return motion.turn * motion.turn / arm; }
};

Polygon moved(const Polygon& shape, const Body& body, const Motion& motion) {
  const Mat2 turn = rotation(motion.turn / body.arm);
  return random::transformed(shape, turn, body.centre + motion.shift - turn * body.centre);
}

// How gaps change by a motion of block 1: rows of a matrix.
std::vector<Vec3> gap_rows(const Outlines& outlines, const std::vector<VertexContact>& contacts, const Body& body) {
  std::vector<Vec3> rows;
  for (const VertexContact& contact : contacts) {
    const Vec2 arm = outlines.current[static_cast<std::size_t>(contact.vertex)] - body.centre;
    const double side = contact.vertex_block == 1 ? 1 : -1;
    rows.push_back(side * Vec3(contact.normal.x(), contact.normal.y(), cross(arm, contact.normal) / body.arm));
  }
  return rows;
}

// min |q|^2 with J q + g >= 0, by Hildreth's method: projections one after the other.
Motion smallest_way_out(const std::vector<Vec3>& rows, const std::vector<VertexContact>& contacts, double uncertain) {
  Vec3 q = Vec3::Zero();
  double deepest = 0;
  for (const VertexContact& contact : contacts) deepest = std::max(deepest, -contact.gap);
  std::vector<double> pressure(rows.size(), 0);
  double change = deepest;
  for (int pass = 0; pass < 5000 && change > 1e-7 * deepest && q.norm() < 1e3 * deepest; ++pass) {
    change = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double next = std::max(0.0, pressure[i] - (rows[i].dot(q) + contacts[i].gap) / rows[i].squaredNorm());
      q += (next - pressure[i]) * rows[i];
      change = std::max(change, std::abs(next - pressure[i]));
      pressure[i] = next;
    }
  }
  bool exists = true;
  for (std::size_t i = 0; i < rows.size(); ++i)
    exists = exists && rows[i].dot(q) + contacts[i].gap >= -0.01 * deepest - uncertain;
  return {q.head<2>(), q(2), exists};
}

// ---- The population.

struct Pair {
  Polygon a, b;          // b where it fits
  double common = 0;     // m, length that they share
  double thickness = 0;  // m, the lesser one's area over its diameter
};

double diameter_of(const Ring& ring) {
  double largest = 0;
  for (const Vec2& i : ring)
    for (const Vec2& j : ring) largest = std::max(largest, (i - j).norm());
  return largest;
}

double common_length_of(const Ring& a, const Ring& b) {
  double length = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (const auto common =
              collinear_overlap({a[i], a[(i + 1) % a.size()]}, {b[j], b[(j + 1) % b.size()]}, least_face))
        length += (common->second - common->first).norm();
  return length;
}

double size_of(const Pair& pair) { return std::sqrt(std::min(area_moments(pair.a).area, area_moments(pair.b).area)); }

// A piece with a hole, and what was cut out of it.
Pair plug_and_frame(SeededNumbers& random) {
  Ring plug = random_piece(random);
  for (Vec2& vertex : plug) vertex *= 0.5;
  const Ring hole(plug.rbegin(), plug.rend());
  const Polygon frame{box_ring(-1, -1, 1, 1), {hole}};
  return {frame, {plug, {}}, 1, 0.2};
}

// Two neighbours; those that share little are taken more often.
Pair random_pair(SeededNumbers& random) {
  if (random.chance(0.03)) return plug_and_frame(random);
  while (true) {
    const std::vector<Ring> blocks = random_blocks(random, random.integer(2, 6));
    const Ring& a = random.one_of(blocks);
    const Ring& b = random.one_of(blocks);
    if (&a == &b) continue;
    Pair pair{{a, {}}, {b, {}}, common_length_of(a, b), 1};
    bool touch = pair.common > 0;
    for (const Vec2& vertex : a) touch = touch || distance_from_outline(pair.b, vertex) < least_face;
    for (const Vec2& vertex : b) touch = touch || distance_from_outline(pair.a, vertex) < least_face;
    const bool is_short = pair.common > 0 && pair.common < 0.1 * size_of(pair);
    if (!touch || defect(pair.a) || defect(pair.b) || !random.chance(is_short ? 1 : 0.1)) continue;
    for (const Ring* ring : {&a, &b})
      pair.thickness = std::min(pair.thickness, signed_area(*ring) / diameter_of(*ring));
    if (pair.thickness > 1e-6) return pair;
  }
}

struct Verdict {
  bool gap_too_deep = false, no_way_out = false, pushes_too_far = false, overlap_missed = false;

  [[nodiscard]] bool is_wrong() const { return gap_too_deep || no_way_out || pushes_too_far || overlap_missed; }
  [[nodiscard]] std::string words() const {
    return std::string(gap_too_deep ? "a gap deeper than the motion; " : "") + (no_way_out ? "no way out; " : "") +
           (pushes_too_far ? "pushes too far; " : "") + (overlap_missed ? "overlap missed" : "");
  }
};

Outlines outlines_of(const Polygon& a, const Polygon& b) {
  Model model;
  for (const Polygon* shape : {&a, &b}) {
    model.blocks.emplace_back().shape = *shape;
    model.blocks.back().moments = area_moments(*shape);
  }
  return make_outlines(model, initial_state(model));
}

// Lengths in sizes of the smaller block, as the search takes them.
constexpr double reach = 0.02;
constexpr double depth = 0.1;
constexpr double round_off = 1e-9;

std::vector<VertexContact> contacts_of(const Outlines& outlines, double size) {
  std::vector<VertexContact> contacts;
  NarrowPhase(outlines).find(0, 1, {reach * size, depth * size, round_off * size}, contacts);
  return contacts;
}

Verdict judge(const Pair& pair, const Motion& motion) {
  Body body{area_moments(pair.b).centroid, diameter_of(pair.b.outer) / 2};
  const Polygon b = moved(pair.b, body, motion);
  double longest = 0;
  for (std::size_t i = 0; i < b.outer.size(); ++i) longest = std::max(longest, (b.outer[i] - pair.b.outer[i]).norm());
  body.centre += motion.shift;
  const Outlines outlines = outlines_of(pair.a, b);
  const std::vector<VertexContact> contacts = contacts_of(outlines, size_of(pair));
  // Cutting leaves faces apart by as much as the least face that it makes.
  const double exact = 3 * least_face + body.second_order(motion);
  Verdict verdict;
  for (const VertexContact& contact : contacts)
    verdict.gap_too_deep = verdict.gap_too_deep || contact.gap < -1.1 * longest - exact;
  const Motion way_out = smallest_way_out(gap_rows(outlines, contacts, body), contacts, exact);
  verdict.no_way_out = !way_out.exists;
  if (verdict.no_way_out) return verdict;
  verdict.pushes_too_far = way_out.size() > 1.15 * motion.size() + exact;
  verdict.overlap_missed = 2 * common_depth(pair.a, moved(b, body, way_out)) > 0.05 * longest + exact;
  return verdict;
}

// By 1e-8 m, which is more than cutting leaves faces apart, to 1e-2 of the smaller block's size, and less than what a
// block is thick: deeper in there are no sides.
Motion random_motion(SeededNumbers& random, const Pair& pair) {
  const double most = std::min(0.01 * size_of(pair), 0.2 * pair.thickness);
  const double length = random.magnitude(-8, std::log10(most));
  return {length * random.number(0, 1) * random.direction(), length * random.number(-1, 1)};
}

int wrong_of(std::uint64_t seed, int count) {
  SeededNumbers random(seed);
  int wrong = 0;
  Pair pair;
  for (int i = 0; i < count; ++i) {
    if (i % 8 == 0) pair = random_pair(random);
    const Motion motion = random_motion(random, pair);
    const Verdict verdict = judge(pair, motion);
    if (!verdict.is_wrong()) continue;
    ++wrong;
    std::printf("pair %d of seed %d: %s (size %.3g, in common %.3g, moved by %.3g)\n", i, static_cast<int>(seed),
                verdict.words().c_str(), size_of(pair), pair.common, motion.size());
  }
  return wrong;
}

TEST(ContactPopulation, ContactsSeparateWhatTheMotionBroughtTogether) { EXPECT_EQ(wrong_of(1, 800), 0); }

// ---- The same pair seen from another side.

using NamesOfContacts = std::vector<std::pair<int, int>>;  // edge and vertex of each

NamesOfContacts names_of_contacts(const Polygon& a, const Polygon& b, double angle, double size) {
  const auto seen = [&](const Polygon& shape) { return random::transformed(shape, rotation(angle), Vec2::Zero()); };
  NamesOfContacts names;
  for (const VertexContact& contact : contacts_of(outlines_of(seen(a), seen(b)), size))
    names.emplace_back(contact.edge, contact.vertex);
  std::sort(names.begin(), names.end());
  return names;
}

// Pairs whose contacts are others when both are turned. They are deeper in each other than contacts are looked for
// apart: corners then lie behind an edge and yet outside of the block. Motions by lot are far from ties that round-off
// decides.
int others_when_turned(std::uint64_t seed, int count) {
  SeededNumbers random(seed);
  int others = 0;
  for (int i = 0; i < count; ++i) {
    const Pair pair = random_pair(random);
    const double size = size_of(pair);
    const double length = std::min(0.05 * size, 0.5 * pair.thickness);
    const Motion motion{length * random.direction(), length * random.number(-1, 1)};
    const Polygon b = moved(pair.b, {area_moments(pair.b).centroid, diameter_of(pair.b.outer) / 2}, motion);
    const NamesOfContacts as_drawn = names_of_contacts(pair.a, b, 0, size);
    for (const double angle : {0.4, 0.8, 1.2}) {
      if (names_of_contacts(pair.a, b, angle, size) == as_drawn) continue;
      ++others;
      break;
    }
  }
  return others;
}

TEST(ContactPopulation, ContactsAreTheSameFromEverySide) { EXPECT_EQ(others_when_turned(1, 2000), 0); }

// One is in doubt: a plug that fills its hole and is turned in it, for which the judge's programme finds no way out.
TEST(ContactPopulation, DISABLED_TwentyThousandPairs) { EXPECT_LE(wrong_of(2, 20000), 1); }

}  // namespace
}  // namespace dda
