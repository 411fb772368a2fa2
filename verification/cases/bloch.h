// Plane waves in a periodic mesh of blocks, by Bloch analysis of the engine's own stiffness and mass matrices: no time
// stepping, no boundaries.
#pragma once

#include <vector>

#include "dda/core/types.h"
#include "dda/geometry/polygon.h"
#include "dda/model/material.h"

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

// Phase speeds (m/s) of the two slowest waves exp(i q.x): S and P.
struct PhaseSpeeds {
  double s = 0, p = 0;
};
[[nodiscard]] PhaseSpeeds phase_speeds(const PeriodicMesh& mesh, const dda::Material& rock,
                                       const dda::JointMaterial& bond, const dda::Vec2& wave_vector,
                                       double strain_inertia = 1);

}  // namespace verify
