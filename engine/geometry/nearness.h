// What edges and corners of a polygon may not do, judged for two of them at a time: touch, repeat, fold back. Lengths
// in m; things nearer than the round-off of the coordinates touch.
#pragma once

#include <limits>

#include "engine/geometry/box.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {

// The round-off of coordinates up to `largest`: two roundings of each of two coordinates.
inline double coordinate_tolerance(double largest) { return 4 * std::numeric_limits<double>::epsilon() * largest; }

// The largest coordinate of the ring by size.
double largest_coordinate_of(const Ring& ring);

// True where all vertices lie on a line. A figure of eight may have area zero too, but is told that it crosses itself.
bool is_flat(const Ring& ring, double tolerance);

// The box of a vertex; those of two vertices that are one but for round-off overlap.
inline Box vertex_box(const Vec2& vertex, double tolerance) { return expanded(Box{vertex, vertex}, tolerance / 2); }

// The box of an edge; edges whose boxes stay apart do not touch.
inline Box edge_box(const Segment& edge, double tolerance) {
  return expanded(expanded(expanded(Box{}, edge.start), edge.end), tolerance);
}

inline bool touch(const Segment& a, const Segment& b, double tolerance) { return distance(a, b) <= tolerance; }

// True where `next`, which begins where `edge` ends, runs back along it.
inline bool folds_back(const Segment& edge, const Segment& next, double tolerance) {
  return distance(edge, next.end) <= tolerance || distance(next, edge.start) <= tolerance;
}

}  // namespace dda
