// What interior passes (interior_passes.h) follow besides the increments: forces of contacts, and the lengths that are
// to vanish with them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "engine/core/types.h"

namespace dda {

// Partners that are to vanish, each with a length: of a normal row f with s, of a tangential one 1 - t/c with z and
// 1 + t/c with y. (Shares of a capacity stay between -1 and 1 whatever that does where it follows the pressures. As
// c - t and c + t they would end steps where it falls.)
struct InteriorRow {
  std::size_t contact;
  Eigen::Index row;
  double stiffness;
  double capacity;  // c, N per m of thickness; < 0: of a normal row
  bool on_bed = false;
  double force = 0;  // f or t, N per m of thickness
  double depth = 0;  // m, of a normal row: what gives way under the force
  // By themselves: the difference of two numbers of one size has no digits when it is small.
  std::array<double, 2> partner{0, 0};
  std::array<double, 2> length{0, 0};  // m
  double share = 0;                    // of the stiffness that the matrix sees
  double constant = 0;                 // N per m of thickness, of the change of the force
  double force_step = 0;               // of the last solve
  double capacity_step = 0;            // the same, where friction follows the pressures
  std::array<double, 2> length_step{0, 0};

  [[nodiscard]] bool is_normal() const { return capacity < 0; }
  [[nodiscard]] int end() const { return static_cast<int>(row) / 2; }
  [[nodiscard]] int products() const { return is_normal() ? 1 : 2; }
  [[nodiscard]] double share_of_capacity() const { return (partner[1] - partner[0]) / 2; }
  // By which a product of partner and length is one of force and length.
  [[nodiscard]] double unit() const { return is_normal() ? 1 : capacity; }
  [[nodiscard]] double partner_step(int i) const {
    if (is_normal()) return force_step;
    return (i == 0 ? -1 : 1) * (force_step - share_of_capacity() * capacity_step) / capacity;
  }
  // What the last solve leaves of unit * partner * length beyond its first order, over the unit.
  [[nodiscard]] double second_order(int i) const {
    const auto n = static_cast<std::size_t>(i);
    const double of_partner = partner_step(i);
    return of_partner * length_step[n] +
           capacity_step / unit() * (partner[n] * length_step[n] + length[n] * of_partner);
  }
  // How far a tangential row slips either way by a force that changes as the products stay, m2/N.
  [[nodiscard]] double slip_by_force(std::size_t i) const { return length[i] / (partner[i] * capacity); }
  // By how much of what its capacity changes the force of a tangential row does. 1 or -1 where it slides.
  [[nodiscard]] double force_by_capacity() const { return share * stiffness * (slip_by_force(0) - slip_by_force(1)); }
};

// The rows of both ends of a stretch on its bed, which lie side by side.
struct InteriorBed {
  std::size_t first;
  Mat2 stiffness = Mat2::Zero();  // N/m per m of thickness, by which the forces fall with both openings
  Mat2 points = Mat2::Zero();     // the same of forces and gaps at the points of the law, as the matrix sees them
};

}  // namespace dda
