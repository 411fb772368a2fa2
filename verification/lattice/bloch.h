// Plane waves in a periodic mesh of blocks, by Bloch analysis of the engine's own stiffness and mass matrices: no time
// stepping, no boundaries.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/material.h"
#include "engine/model/model.h"
#include "verification/lattice/periodic_mesh.h"

namespace verify {

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
