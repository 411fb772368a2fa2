#include "engine/keyblocks/first_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

Vec2 tangent(const JointFace& face) { return {-face.outward.y(), face.outward.x()}; }

bool is_along(const JointFace& face, const Vec2& unit) { return std::abs(face.outward.dot(unit)) <= along_the_way; }

double infinite() { return std::numeric_limits<double>::infinity(); }

double safety(double resistance, double drive) { return drive > 0 ? resistance / drive : infinite(); }

// Where the projection of `force` on the permitted ways lies: itself, on a face, or nowhere.
Vec2 projected(std::span<const JointFace> faces, const Vec2& force) {
  if (permits(faces, force)) return force;
  Vec2 best = Vec2::Zero();
  for (const JointFace& face : faces) {
    const double pressing = face.outward.dot(force);
    if (pressing <= 0) continue;
    const Vec2 along = tangent(face).dot(force) * tangent(face);
    const bool is_a_way = along.norm() > along_the_way * force.norm() && permits(faces, along);
    if (is_a_way && along.norm() > best.norm()) best = along;
  }
  return best;
}

// Ends of the cone of permitted ways: tangents of faces.
std::vector<Vec2> permitted_tangents(std::span<const JointFace> faces) {
  std::vector<Vec2> ends;
  for (const JointFace& face : faces) {
    for (const double sign : {1.0, -1.0}) {
      const Vec2 way = sign * tangent(face);
      if (permits(faces, way)) ends.push_back(way);
    }
  }
  return ends;
}

double angle_of(const Vec2& way) { return std::atan2(way.y(), way.x()); }

}  // namespace

bool permits(std::span<const JointFace> faces, const Vec2& way) {
  const double most = along_the_way * way.norm();
  return std::all_of(faces.begin(), faces.end(), [&](const JointFace& face) { return face.outward.dot(way) <= most; });
}

bool is_removable(std::span<const JointFace> faces) { return faces.empty() || !permitted_tangents(faces).empty(); }

std::vector<Ways> permitted_ways(std::span<const JointFace> faces) {
  if (faces.empty()) return {{-std::numbers::pi, std::numbers::pi}};
  const std::vector<Vec2> ends = permitted_tangents(faces);
  if (ends.empty()) return {};
  // From the end that all others lie counter-clockwise of, at half a turn at most.
  const auto inside = [&](const Vec2& way) { return permits(faces, way); };
  for (const Vec2& first : ends) {
    const auto turn = [&](const Vec2& way) {
      const double angle = std::atan2(cross(first, way), first.dot(way));
      return angle < -along_the_way ? angle + 2 * std::numbers::pi : std::max(angle, 0.0);
    };
    const Vec2 last =
        *std::max_element(ends.begin(), ends.end(), [&](const Vec2& a, const Vec2& b) { return turn(a) < turn(b); });
    const double opening = turn(last);
    const Vec2 middle(std::cos(angle_of(first) + opening / 2), std::sin(angle_of(first) + opening / 2));
    if (opening <= std::numbers::pi + along_the_way && inside(middle))
      return {{angle_of(first), angle_of(first) + opening}};
  }
  return {{angle_of(ends.front()), angle_of(ends.front())}, {angle_of(-ends.front()), angle_of(-ends.front())}};
}

std::string_view to_string(Mode mode) {
  constexpr std::array<std::string_view, 4> names{"keyed", "stable", "slides", "falls"};
  return names[static_cast<std::size_t>(mode)];
}

Grip grip_along(std::span<const JointFace> faces, const Vec2& way, const Vec2& normal) {
  Grip grip;
  double length = 0;
  double weighted = 0;
  double sum = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!is_along(faces[i], way)) continue;
    grip.cohesion_force += faces[i].cohesion_force;
    if (faces[i].outward.dot(normal) <= 0) continue;
    grip.pressed.push_back(static_cast<int>(i));
    length += faces[i].length();
    weighted += faces[i].length() * faces[i].tan_friction;
    sum += faces[i].tan_friction;
  }
  if (length > 0)
    grip.tan_friction = weighted / length;
  else if (!grip.pressed.empty())  // corners alone
    grip.tan_friction = sum / static_cast<double>(grip.pressed.size());
  return grip;
}

FirstMotion first_motion(std::span<const JointFace> faces, const Vec2& force) {
  FirstMotion motion;
  motion.factor_of_safety = infinite();
  if (!is_removable(faces)) return motion;
  motion.mode = Mode::stable;
  if (force.norm() == 0) return motion;
  const Vec2 drive = projected(faces, force);
  motion.drive = drive.norm();
  if (motion.drive == 0) return motion;
  motion.direction = drive / motion.drive;
  const Vec2 pressing = force - drive;
  Grip grip = grip_along(faces, motion.direction, pressing);
  motion.mode = pressing.norm() > 0 ? Mode::slides : Mode::falls;
  motion.pressed = std::move(grip.pressed);
  motion.resistance = pressing.norm() * grip.tan_friction + grip.cohesion_force;
  motion.factor_of_safety = safety(motion.resistance, motion.drive);
  return motion;
}

}  // namespace dda
