// Generators of valid polygons for property tests. Coordinates are multiples of 2^-20 m, so that a translation by an
// integer below 2^32 is exact.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/polygon.h"

namespace dda::random {

// Uniform in [lower, upper]. The library would start with values near the lower end and widen with every test.
inline int integer(int lower, int upper) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lower, upper + 1));
}

// Uniform in [lower, upper], a multiple of 2^-20.
inline double number(double lower, double upper) {
  constexpr double grid = 1 << 20;
  return integer(static_cast<int>(lower * grid), static_cast<int>(upper * grid)) / grid;
}

inline Vec2 point(double half_width) { return {number(-half_width, half_width), number(-half_width, half_width)}; }

inline double on_grid(double value) { return std::round(std::ldexp(value, 20)) / (1 << 20); }

// Counter-clockwise and star-shaped about the origin, with radii from 0.25 to 2 m: convex or concave. At least four
// directions, none a half turn from the next, keep the origin inside.
inline Ring star() {
  const int count = integer(4, 12);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + number(0, 0.75)) / count;
    const double radius = number(0.25, 2);
    ring.push_back({on_grid(radius * std::cos(angle)), on_grid(radius * std::sin(angle))});
  }
  return ring;
}

inline Ring scaled(const Ring& ring, double factor) {
  Ring result;
  for (const Vec2& vertex : ring) result.push_back({on_grid(factor * vertex.x()), on_grid(factor * vertex.y())});
  return result;
}

// A star, half the time with a hole of the same shape, half its size.
inline Polygon polygon() {
  Polygon result = {star(), {}};
  if (*rc::gen::arbitrary<bool>()) result.holes.push_back(scaled(result.outer, 0.5));
  return result;
}

// The polygon turned by `matrix` and then moved by `shift`.
inline Polygon transformed(Polygon given, const Mat2& matrix, const Vec2& shift) {
  const auto move = [&](Ring& ring) {
    for (Vec2& vertex : ring) vertex = matrix * vertex + shift;
  };
  move(given.outer);
  for (Ring& hole : given.holes) move(hole);
  return given;
}

}  // namespace dda::random
