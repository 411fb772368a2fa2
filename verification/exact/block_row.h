// A row of equal elastic blocks that run into each other: the discrete equations of first-order blocks (centroid u and
// mean strain e of each, no lateral contraction) with springs that only push, integrated by the classical Runge-Kutta
// method, in steps that are short against every period and end where a contact opens or closes.
//
//   m u_i'' = F_(i-1) - F_i                  m L^2/12 e_i'' = -E A L e_i - L/2 (F_(i-1) + F_i)
//   F_i = k max(0, -gap_i)                   gap_i = gap of rest + u_(i+1) - u_i - L/2 (e_i + e_(i+1))
#pragma once

#include <vector>

namespace exact {

struct BlockRow {
  double mass = 0;               // kg, of a block
  double length = 0;             // m, of a block, L
  double axial_stiffness = 0;    // N, E A
  double spring = 0;             // N/m, of a contact
  std::vector<double> gaps;      // m, between neighbours at the start; one less than blocks
  std::vector<double> velocity;  // m/s, of each block at the start
};

struct BlockRowState {
  std::vector<double> position;  // m, since the start, of the centroids
  std::vector<double> velocity;  // m/s
  double vibration = 0;          // J, energy of the strains and of their rates
};

// The row at time `end` (s). Energy is kept to 1e-10.
[[nodiscard]] BlockRowState move_block_row(const BlockRow& row, double end);

}  // namespace exact
