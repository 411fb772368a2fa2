// Plane waves in a periodic mesh of blocks, by Bloch analysis of the engine's own stiffness and mass matrices: no time
// stepping, no boundaries.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dda/core/types.h"
#include "dda/geometry/polygon.h"
#include "dda/model/material.h"
#include "dda/model/model.h"

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

[[nodiscard]] PeriodicMesh voronoi_mesh(unsigned seed);  // of 16 random points in 4 x 4 m, no two closer than 0.55 m

// The cell with its eight neighbours, 3 x 3: cell c lies (c/3 - 1) times `first` and (c % 3 - 1) times `second` away.
constexpr int middle_cell = 4;
[[nodiscard]] dda::Vec2 translation(const PeriodicMesh& mesh, int cell);

// The engine's matrices of the middle cell, 6 rows a block (N/m, kg and so on per m of thickness).
struct CellMatrices {
  dda::Model model;                          // of all nine cells, cell by cell
  std::array<Eigen::MatrixXd, 9> stiffness;  // forces on the middle cell by the motion of each cell
  std::array<Eigen::MatrixXd, 9>
      interfaces;  // the part of stiffness[middle_cell] that stems from joints with each cell
  Eigen::MatrixXd mass;
};
// `corrected`: for the blocks' size, as scenes have it that leave it unsaid (Stage::correct_block_dispersion).
[[nodiscard]] CellMatrices cell_matrices(const PeriodicMesh& mesh, const dda::Material& rock,
                                         const dda::JointMaterial& bond, bool corrected = false);

// Phase speeds (m/s) of the two slowest waves exp(i q.x): S and P.
struct PhaseSpeeds {
  double s = 0, p = 0;
};
[[nodiscard]] PhaseSpeeds phase_speeds(const PeriodicMesh& mesh, const dda::Material& rock,
                                       const dda::JointMaterial& bond, const dda::Vec2& wave_vector,
                                       bool corrected = false);

}  // namespace verify
