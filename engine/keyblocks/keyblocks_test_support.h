// What the tests of this folder share: outlines with joints along some of their edges, and how they are moved.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/keyblocks/rock_bodies.h"

namespace dda {

inline constexpr double degree = std::numbers::pi / 180;

struct Strength {
  double friction_angle = 0;  // rad
  double cohesion = 0;        // Pa
};

// An edge of an outline, with the body on its left.
inline JointFace face_along(const Vec2& from, const Vec2& to, const Strength& strength) {
  JointFace face;
  face.from = from;
  face.to = to;
  const Vec2 along = (to - from).normalized();
  face.outward = Vec2(along.y(), -along.x());
  face.tan_friction = std::tan(strength.friction_angle);
  face.cohesion_force = strength.cohesion * (to - from).norm();
  return face;
}

// A body of density 1 with joints along these edges of its outline, which turns counter-clockwise.
inline RockBody body_with_joints(const Ring& outline, const std::vector<int>& edges, const Strength& strength) {
  RockBody body;
  const AreaMoments moments = area_moments({outline, {}});
  body.area = body.mass = moments.area;
  body.centroid = moments.centroid;
  for (const int edge : edges) {
    const auto first = static_cast<std::size_t>(edge);
    body.joints.push_back(face_along(outline[first], outline[(first + 1) % outline.size()], strength));
  }
  return body;
}

inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace dda
