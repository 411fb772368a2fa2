#include "engine/cutting/opening_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dda {
namespace {

// Appends points on an arc, counter-clockwise when `sweep` is positive, without that at its end.
void append_arc(Ring& ring, const Vec2& centre, double radius, double first, double sweep, double chord_tolerance) {
  const double share = std::min(chord_tolerance / radius, 0.5);
  const double widest = 2 * std::acos(1 - share);
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / widest - 1e-9)));
  for (int i = 0; i < chords; ++i) {
    const double angle = first + sweep * i / chords;
    ring.emplace_back(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle));
  }
}

}  // namespace

Ring circle(const Vec2& centre, double radius, double chord_tolerance) {
  Ring ring;
  append_arc(ring, centre, radius, 0, 2 * std::numbers::pi, chord_tolerance);
  return ring;
}

Ring rectangle(const Vec2& foot, double width, double height) {
  const Vec2 half(width / 2, 0);
  const Vec2 up(0, height);
  return {foot - half, foot + half, foot + half + up, foot - half + up};
}

Ring arch(const Vec2& foot, double width, double height, double rise, double chord_tolerance) {
  const Vec2 half(width / 2, 0);
  const double wall = height - rise;
  Ring ring{foot - half, foot + half};
  if (rise == 0) return rectangle(foot, width, height);
  const double radius = (width * width / 4 + rise * rise) / (2 * rise);
  const double angle = std::asin(std::min(1.0, width / 2 / radius));  // half of what the roof spans
  const Vec2 centre = foot + Vec2(0, height - radius);
  if (wall <= 0) ring.clear();
  append_arc(ring, centre, radius, std::numbers::pi / 2 - angle, 2 * angle, chord_tolerance);
  ring.push_back(foot - half + Vec2(0, wall));
  return ring;
}

Ring horseshoe(const Vec2& foot, double width, double height, double chord_tolerance) {
  const double wall = height - width / 2;  // from the floor to where the roof springs
  const Vec2 middle = foot + Vec2(0, wall);
  const Vec2 half(width / 2, 0);
  const double bend = std::asin(std::min(1.0, wall / width));
  Ring ring;
  if (wall > 0) append_arc(ring, middle - half, width, -bend, bend, chord_tolerance);
  append_arc(ring, middle, width / 2, 0, std::numbers::pi, chord_tolerance);
  if (wall > 0) append_arc(ring, middle + half, width, std::numbers::pi, bend, chord_tolerance);
  const double floor = width * std::cos(bend) - width / 2;
  ring.emplace_back(foot.x() - floor, foot.y());
  return ring;
}

}  // namespace dda
