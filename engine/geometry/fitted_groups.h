// Polygons that fit together side by side, as blocks cut from one rock do: that no two of them overlap is told by
// counting their sides, without looking at pairs.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

inline constexpr int no_group = -1;

// The number of a group by polygon: no two of a group have any ground in common. Polygons of which that is not known
// have no group, so nothing is said of them, nor of polygons of two groups. All must be valid (defect()) and
// normalized(). Fit means to the last bit: a group are polygons whose sides have the same two corners as one of a
// neighbour, but for those along the group's outline, which must not touch itself.
std::vector<int> groups_that_fit(std::span<const Polygon* const> polygons);

}  // namespace dda
