// Random bodies, convex and concave, with joints along some of their edges: what must hold for all of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/geometry/random_polygon.h"
#include "engine/keyblocks/bolt_force.h"
#include "engine/keyblocks/first_motion.h"
#include "engine/keyblocks/keyblocks_test_support.h"

namespace dda {
namespace {

struct Loaded {
  std::vector<JointFace> faces;
  Vec2 force;
  double wanted = 1;
};

Loaded random_body() {
  const Ring outline = random::star();
  Loaded body;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Strength strength{random::number(0, 1.2), random::integer(0, 1) * random::number(0, 2)};
    if (random::integer(0, 2) > 0)
      body.faces.push_back(face_along(outline[i], outline[(i + 1) % outline.size()], strength));
  }
  if (random::integer(0, 3) == 0 && !body.faces.empty()) {  // the other side of a parallel-sided body
    JointFace other = body.faces.front();
    std::swap(other.from, other.to);
    other.outward = -other.outward;
    body.faces.push_back(other);
  }
  body.force = random::number(0.5, 5) * unit(random::number(-3, 3));
  body.wanted = random::number(0.5, 3);
  return body;
}

// Near the borders between modes round-off decides: bodies for which a force turned by a little moves otherwise.
bool is_on_a_border(const Loaded& body) {
  const FirstMotion here = first_motion(body.faces, body.force);
  return std::any_of(body.faces.begin(), body.faces.end(),
                     [&](const JointFace& face) {
                       const Vec2 along(-face.outward.y(), face.outward.x());
                       const double least = 1e-4 * body.force.norm();
                       return std::abs(face.outward.dot(body.force)) < least || std::abs(along.dot(body.force)) < least;
                     }) ||
         std::abs(here.factor_of_safety / body.wanted - 1) < 1e-6;
}

// The way of the largest share of the force among many ways: what the projection must be, found without it.
RC_GTEST_PROP(FirstMotionProperties, TheWayIsThatOfMostWork, ()) {
  const Loaded body = random_body();
  RC_PRE(!is_on_a_border(body));
  const FirstMotion motion = first_motion(body.faces, body.force);
  constexpr int ways = 3600;
  double most = 0;
  bool any = false;
  for (int i = 0; i < ways; ++i) {
    const Vec2 way = unit(2 * std::numbers::pi * i / ways);
    if (!permits(body.faces, way)) continue;
    any = true;
    most = std::max(most, way.dot(body.force));
  }
  // Between two ways that are tried the share falls short by at most the angle between them.
  const double step = 2 * std::numbers::pi / ways;
  RC_ASSERT(motion.drive >= most * (1 - 1e-12));
  if (any && most > step * body.force.norm()) RC_ASSERT(motion.drive <= most + step * body.force.norm());
  if (any) RC_ASSERT(motion.mode != Mode::keyed);
  if (motion.mode == Mode::slides || motion.mode == Mode::falls) RC_ASSERT(permits(body.faces, motion.direction));
}

// Rotated, mirrored, made larger: lengths and forces scale, factors stay.
RC_GTEST_PROP(FirstMotionProperties, DoesNotDependOnTheFrame, ()) {
  const Loaded body = random_body();
  RC_PRE(!is_on_a_border(body));
  const double scale = random::number(0.01, 100);
  const Vec2 shift = random::point(1000);
  const bool mirrored = random::integer(0, 1) == 1;
  Mat2 turn;
  const double angle = random::number(-3, 3);
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  if (mirrored) turn.col(0) *= -1;
  Loaded moved = body;
  for (JointFace& face : moved.faces) {
    const Vec2 from = scale * (turn * face.from) + shift;
    const Vec2 to = scale * (turn * face.to) + shift;
    face.from = mirrored ? to : from;
    face.to = mirrored ? from : to;
    face.outward = turn * face.outward;
    face.cohesion_force *= scale;
  }
  moved.force = scale * (turn * body.force);
  const FirstMotion here = first_motion(body.faces, body.force);
  const FirstMotion there = first_motion(moved.faces, moved.force);
  RC_ASSERT(here.mode == there.mode);
  if (std::isfinite(here.factor_of_safety))
    RC_ASSERT(std::abs(here.factor_of_safety - there.factor_of_safety) <= 1e-9 * (1 + here.factor_of_safety));
  RC_ASSERT((turn * here.direction - there.direction).norm() <= 1e-9);
  const Vec2 bolt = turn * least_bolt_force(body.faces, body.force, body.wanted) * scale;
  const Vec2 other = least_bolt_force(moved.faces, moved.force, body.wanted);
  RC_ASSERT(std::abs(bolt.norm() - other.norm()) <= 1e-8 * moved.force.norm());
}

// Bolts that pull with up to `most` hold what acts with joints of less strength, and F times as much with all of it.
// Told without lines and crossings: by trying many shares.
bool bolts_hold(const Loaded& body, const Vec2& most, double allowed) {
  bool weak = false;
  bool loaded = false;
  constexpr int shares = 2000;
  for (int i = 0; i <= shares; ++i) {
    const Vec2 bolt = static_cast<double>(i) / shares * most;
    const auto safety = [&](const Vec2& total) { return first_motion(body.faces, total).factor_of_safety; };
    weak = weak || safety(body.force + bolt) >= body.wanted * (1 - allowed);
    loaded = loaded || safety(body.wanted * body.force + bolt) >= 1 - allowed;
  }
  return weak && loaded;
}

// What bolts give is what was wanted, and nothing smaller does.
RC_GTEST_PROP(FirstMotionProperties, BoltsGiveWhatIsWanted, ()) {
  const Loaded body = random_body();
  const Vec2 direction = unit(random::number(-3.1, 3.1));
  const auto force = bolt_force(body.faces, body.force, direction, body.wanted);
  if (!force) {
    RC_ASSERT(!bolts_hold(body, 20 * body.force.norm() * direction, -1e-8));
    return;
  }
  // A little more, where the share that is just enough lies between two that are tried.
  RC_ASSERT(bolts_hold(body, *force * direction, 1e-8) || bolts_hold(body, 1.001 * *force * direction, 1e-2));
  if (*force > 0) RC_ASSERT(!bolts_hold(body, 0.999 * *force * direction, -1e-8));
}

// More safety never needs less force.
RC_GTEST_PROP(FirstMotionProperties, BoltsGrowWithTheFactor, ()) {
  const Loaded body = random_body();
  const Vec2 direction = unit(random::number(-3.1, 3.1));
  const double more = body.wanted * random::number(1, 2);
  const auto force = bolt_force(body.faces, body.force, direction, body.wanted);
  const auto larger = bolt_force(body.faces, body.force, direction, more);
  if (larger) RC_ASSERT(force.has_value() && *force <= *larger * (1 + 1e-8) + 1e-12);
  const double least = least_bolt_force(body.faces, body.force, body.wanted).norm();
  RC_ASSERT(least <= least_bolt_force(body.faces, body.force, more).norm() * (1 + 1e-8) + 1e-12);
}

// No direction needs less than the best.
RC_GTEST_PROP(FirstMotionProperties, NoBoltsNeedLessThanTheLeast, ()) {
  const Loaded body = random_body();
  const Vec2 least = least_bolt_force(body.faces, body.force, body.wanted);
  constexpr int directions = 180;
  for (int i = 0; i < directions; ++i) {
    const auto force = bolt_force(body.faces, body.force, unit(2 * std::numbers::pi * i / directions), body.wanted);
    if (force) RC_ASSERT(least.norm() <= *force * (1 + 1e-8) + 1e-12);
  }
  if (least.norm() == 0) return;
  const auto along = bolt_force(body.faces, body.force, least.normalized(), body.wanted);
  if (along) RC_ASSERT(std::abs(*along - least.norm()) <= 1e-6 * body.force.norm());
}

// The ways given are permitted, and what lies a little beyond them is not.
RC_GTEST_PROP(FirstMotionProperties, WaysEndWhereFacesAre, ()) {
  const Loaded body = random_body();
  const std::vector<Ways> ways = permitted_ways(body.faces);
  RC_ASSERT(ways.empty() == !is_removable(body.faces));
  for (const Ways& way : ways) {
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      // Both ends hold to round-off of the angle; `permits` has room for that.
      RC_ASSERT(permits(body.faces, unit(way.from + share * (way.to - way.from))));
    }
    if (body.faces.empty()) continue;
    RC_ASSERT(!permits(body.faces, unit(way.from - 1e-5)));
    RC_ASSERT(!permits(body.faces, unit(way.to + 1e-5)));
  }
}

}  // namespace
}  // namespace dda
