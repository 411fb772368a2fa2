// Plane waves in an endless mesh of square blocks whose displacements are polynomials of first or second order, joined
// by Nitsche's method (symmetric interior penalty): a prototype of second-order blocks, by Bloch analysis.
#pragma once

namespace exact {

struct NitscheBlocks {
  int order = 1;               // of the displacement field: 6 unknowns a block, or 12
  bool mid_edge = false;       // the joint's terms at the middle of the edge alone, with end-to-end stabilisation
  double penalty = 4;          // of the gap, in units of plane modulus over block side
  double stabilisation = 0.1;  // of half the difference of the gap between the ends, the same units; mid_edge only
  double poisson = 0.25;       // plane stress

  [[nodiscard]] int unknowns() const { return order == 1 ? 6 : 12; }
};

// Phase speed over that of the continuum, minus 1, of a wave with so many blocks in its wavelength that runs `degrees`
// off the x axis. Throws std::invalid_argument if the mesh is not stable for it (penalty too small).
struct SpeedErrors {
  double s = 0, p = 0;
};
[[nodiscard]] SpeedErrors speed_errors(const NitscheBlocks& blocks, double blocks_per_wavelength, double degrees);

// Largest magnitude of both over the directions from 0 to 45 degrees (the mesh has the symmetry of the square).
[[nodiscard]] double worst_speed_error(const NitscheBlocks& blocks, double blocks_per_wavelength);

// Fewest blocks in the wavelength, to 0.5 %, with which the worst error is at most `error`: bisected between 2.5 and
// 200.
[[nodiscard]] double blocks_needed(const NitscheBlocks& blocks, double error);

}  // namespace exact
