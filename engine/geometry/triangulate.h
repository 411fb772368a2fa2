// Cutting a polygon with holes into triangles, for display.
#pragma once

#include <array>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

// Indices of counter-clockwise corners into the vertices of `polygon`: those of the outer ring, then those of each
// hole.
using Triangle = std::array<int, 3>;

// Cuts a valid polygon (see defect()), of either orientation, by clipping ears after the holes are joined to the outer
// ring by bridges (Meisters 1975; Eberly, "Triangulation by ear clipping"). Sides are judged with exact arithmetic, so
// that flat corners and vertices in line are safe. With n vertices and h holes there are n + 2 h - 2 triangles;
// together they use every vertex and meet edge to edge. Takes time of order n^2. Throws std::invalid_argument for rings
// that cross.
std::vector<Triangle> triangulate(const Polygon& polygon);

// True when the polygon has no hole and no corner that points inwards; flat corners are allowed.
bool is_convex(const Polygon& polygon);

}  // namespace dda
