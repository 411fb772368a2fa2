// Meshes that repeat themselves: a cell of blocks and the translations that fill the plane with it.
#pragma once

#include <vector>

#include "engine/core/types.h"
#include "engine/geometry/polygon.h"

namespace verify {

// Blocks of one cell and the two translations that repeat it without gaps.
struct PeriodicMesh {
  std::vector<dda::Ring> cell;
  dda::Vec2 first, second;

  [[nodiscard]] double longest_side() const;  // m, of all blocks
};

[[nodiscard]] PeriodicMesh square_mesh();                  // 1 x 1 m
[[nodiscard]] PeriodicMesh brick_mesh();                   // 1 x 0.5 m, running bond
[[nodiscard]] PeriodicMesh sheared_mesh();                 // rhomboids of 1 m, 30 degrees off the square
[[nodiscard]] PeriodicMesh triangle_mesh();                // squares cut along a diagonal
[[nodiscard]] PeriodicMesh irregular_mesh(unsigned seed);  // 4 x 4 quadrilaterals, corners moved by up to 0.2 m
// The Voronoi polygons of 16 random points in 4 x 4 m, no two closer than 0.55 m.
[[nodiscard]] PeriodicMesh voronoi_mesh(unsigned seed);

// What of a convex ring is nearer to `own` than to `other`: cutting by all others gives the Voronoi polygon of `own`.
[[nodiscard]] dda::Ring nearer_part(const dda::Ring& ring, const dda::Vec2& own, const dda::Vec2& other);

// The cell with its eight neighbours, 3 x 3: cell c lies (c/3 - 1) times `first` and (c % 3 - 1) times `second` away.
constexpr int middle_cell = 4;
[[nodiscard]] dda::Vec2 translation(const PeriodicMesh& mesh, int cell);

}  // namespace verify
