#include "engine/geometry/polygon.h"

#include <algorithm>
#include <limits>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

// Integrals of 1, (x, y), x^2, y^2 and xy over the area on the left of a ring.
struct RawMoments {
  double area = 0;
  Vec2 first = Vec2::Zero();
  double xx = 0;
  double yy = 0;
  double xy = 0;

  void add(const RawMoments& other, double sign) {
    area += sign * other.area;
    first += sign * other.first;
    xx += sign * other.xx;
    yy += sign * other.yy;
    xy += sign * other.xy;
  }
};

// The part of the triangle (origin, a, b), signed; a and b relative to the reference point.
RawMoments triangle_moments(const Vec2& a, const Vec2& b) {
  const double twice_area = cross(a, b);
  RawMoments moments;
  moments.area = twice_area / 2;
  moments.first = twice_area / 6 * (a + b);
  moments.xx = twice_area / 12 * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  moments.yy = twice_area / 12 * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
  moments.xy = twice_area / 24 * (a.x() * b.y() + 2 * a.x() * a.y() + 2 * b.x() * b.y() + b.x() * a.y());
  return moments;
}

// About `origin` + `shift`. The two are kept apart so that the shift is not rounded to the coordinates' spacing.
RawMoments ring_moments(const Ring& ring, const Vec2& origin, const Vec2& shift) {
  RawMoments sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& next = ring[(i + 1) % ring.size()];
    sum.add(triangle_moments(ring[i] - origin - shift, next - origin - shift), 1);
  }
  return sum;
}

RawMoments polygon_moments(const Polygon& polygon, const Vec2& origin, const Vec2& shift) {
  RawMoments sum;
  const auto add = [&](const Ring& ring, double sign) {
    const RawMoments moments = ring_moments(ring, origin, shift);
    sum.add(moments, moments.area < 0 ? -sign : sign);
  };
  add(polygon.outer, 1);
  for (const Ring& hole : polygon.holes) add(hole, -1);
  return sum;
}

// Turns a ring round, keeping its first vertex.
void reverse(Ring& ring) { std::reverse(ring.begin() + 1, ring.end()); }

// By counting the edges that a ray to the right of `point` crosses.
bool ray_says_inside(const Ring& ring, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double side = cross(b - a, point - a);
    if ((b.y() > a.y()) == (side > 0)) inside = !inside;
  }
  return inside;
}

Location locate_in_ring(const Ring& ring, const Vec2& point, double tolerance) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (distance(Segment{ring[i], ring[(i + 1) % ring.size()]}, point) <= tolerance) return Location::boundary;
  }
  return ray_says_inside(ring, point) ? Location::inside : Location::outside;
}

}  // namespace

double signed_area(const Ring& ring) { return ring.empty() ? 0 : ring_moments(ring, ring.front(), Vec2::Zero()).area; }

Polygon normalized(Polygon polygon) {
  if (signed_area(polygon.outer) < 0) reverse(polygon.outer);
  for (Ring& hole : polygon.holes) {
    if (signed_area(hole) > 0) reverse(hole);
  }
  return polygon;
}

double perimeter(const Polygon& polygon) {
  const auto of_ring = [](const Ring& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
    return sum;
  };
  double sum = of_ring(polygon.outer);
  for (const Ring& hole : polygon.holes) sum += of_ring(hole);
  return sum;
}

double extent_along(const Ring& ring, const Vec2& direction) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec2& vertex : ring) {
    least = std::min(least, direction.dot(vertex));
    most = std::max(most, direction.dot(vertex));
  }
  return most - least;
}

AreaMoments area_moments(const Polygon& polygon) {
  const Vec2& origin = polygon.outer.front();
  const RawMoments about_vertex = polygon_moments(polygon, origin, Vec2::Zero());
  const Vec2 shift = about_vertex.first / about_vertex.area;
  // A second pass about the centroid, rather than the parallel-axis theorem, loses no digits of a slender polygon.
  const RawMoments about_centroid = polygon_moments(polygon, origin, shift);
  return {about_vertex.area, origin + shift, about_centroid.xx, about_centroid.yy, about_centroid.xy};
}

Location locate(const Polygon& polygon, const Vec2& point, double tolerance) {
  const Location in_outer = locate_in_ring(polygon.outer, point, tolerance);
  if (in_outer != Location::inside) return in_outer;
  for (const Ring& hole : polygon.holes) {
    const Location in_hole = locate_in_ring(hole, point, tolerance);
    if (in_hole == Location::boundary) return Location::boundary;
    if (in_hole == Location::inside) return Location::outside;
  }
  return Location::inside;
}

bool contains(const Polygon& polygon, const Vec2& point) { return locate(polygon, point) != Location::outside; }

}  // namespace dda
