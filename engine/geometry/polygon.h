// Simple polygons with holes: validity, exact area moments, point location. Lengths in m.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/types.h"

namespace dda {

using Ring = std::vector<Vec2>;  // closed boundary; the first vertex is not repeated at the end

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

// Exact integrals over a polygon. Second moments are about the centroid.
struct AreaMoments {
  double area = 0;               // m2
  Vec2 centroid = Vec2::Zero();  // m
  double xx = 0;                 // integral of (x - xc)^2 dA, m4
  double yy = 0;                 // integral of (y - yc)^2 dA, m4
  double xy = 0;                 // integral of (x - xc)(y - yc) dA, m4
};

enum class Location { outside, boundary, inside };

// Area enclosed by the ring, positive when counter-clockwise. Evaluated about the first vertex.
double signed_area(const Ring& ring);

// The same polygon with the outer ring counter-clockwise and the holes clockwise, so that material lies on the left of
// every edge. The first vertex of each ring stays first.
Polygon normalized(Polygon polygon);

// Area, centroid and second moments by Green's theorem on the straight edges (Shi's simplex integration). Needs a
// valid polygon, of either orientation; precise far from the origin, because integrals are taken about a vertex and
// then about the centroid.
AreaMoments area_moments(const Polygon& polygon);

// Length of all rings, m.
double perimeter(const Polygon& polygon);

// Extent of the outline along a unit vector, m.
double extent_along(const Ring& ring, const Vec2& direction);

// Why `polygon` is not a valid simple polygon, in words that end a sentence "block is ...", or nothing when it is:
// fewer than three vertices, a coordinate that is not finite or beyond 1e12 m, repeated vertices, zero area, edges that
// cross, touch or fold back, a hole outside, or holes that touch or nest. Things nearer than the round-off of the
// coordinates touch.
std::optional<std::string> defect(const Polygon& polygon);

// Where `point` lies; within `tolerance` (m) of an edge it is on the boundary.
Location locate(const Polygon& polygon, const Vec2& point, double tolerance = 0);

// True inside the material or on its boundary; false in a hole.
bool contains(const Polygon& polygon, const Vec2& point);

}  // namespace dda
