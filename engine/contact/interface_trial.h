// An interface in the course of a step, and how the step looks at contacts.
#pragma once

#include <array>
#include <cstddef>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"

namespace dda {

// How a stage and its time step look at contacts.
struct ContactRule {
  bool conserves_energy = false;   // normal forces whose work over the step is the change of the springs' energy
  bool sticks = false;             // closed contacts do not slide and joints do not break: unlimited strength in shear
  double touching = 0;             // m; contacts with a smaller gap at the start of the step stick, if `sticks`
  double dashpot_rate = 0;         // 1/s: a dashpot's force in the balance is dashpot * dashpot_rate * change of gap
  bool capacity_is_given = false;  // by the normal forces at the start of the step, whatever they are at its end
};

// An interface in the course of a step. What broken ends answer, for the change of the gap from g0 to g1:
//   spring              k min(0, g1) above the dilation of the step; conserving: 2 (V1 - V0)/(g1 - g0) - k min(0, g0)
//   with V = k min(0, g)^2/2, which
//   a
//                       balance of means (alpha_f = 1/2) turns into the discrete gradient of V (Gonzalez 1996)
//   dashpot             C (min(0, g1) - min(0, g0)), C = dashpot * dashpot_rate, and no pull of both together
//   shear while closed  k g1 + C (g1 - g0), at most the capacity. Conserving: the mean of this and the shear of the
//                       start is at most the friction of the mean normal force, so that slip, which goes the way of
//                       the mean, always takes energy; the spring itself keeps no more than that friction.
// Each is a non-decreasing function of g1, so every one has a convex potential. The normal springs of broken projected
// stretches press together (no_tension_bed.h), and have one too.
struct InterfaceTrial {
  Vec4 start = Vec4::Zero();             // m, gap at the start of the step
  Vec4 gap = Vec4::Zero();               // m, at the displacements reached so far; tangential without earlier slip
  Vec4 direction = Vec4::Zero();         // m, its change along the full Newton step
  Vec4 force = Vec4::Zero();             // N per m of thickness, at `gap`, what the balance of the step sees
  Vec4 active = Vec4::Ones();            // d force/d gap over the stiffness: 0 for open or sliding rows, mostly 1 else
  double coupling = 0;                   // N/m per m of thickness, of two forces by the other's gap: coupled_row()
  Vec4 before = Vec4::Zero();            // N per m of thickness, of the start, where the balance takes means with it
  std::array<double, 2> capacity{0, 0};  // N per m of thickness, largest shear force of a broken end; with `before`
  std::array<bool, 2> broken{false, false};
  std::array<bool, 2> residual{false, false};
  std::array<bool, 2> closes{false, false};  // ends that dilate and do not in this step: they were open at its start
                                             // (rising_end.h), or friction is given
  ContactRule rule;

  std::array<double, 2> torn{0, 0};       // of the length, before the step
  std::array<double, 2> slip{0, 0};       // m, before the step
  std::array<double, 2> dilation{0, 0};   // m, in the step: the normal gap closes at it
  std::array<double, 2> owed{0, 0};       // m, by which it has come down in steps before and is lowered in this one
  std::array<double, 2> hardening{0, 0};  // N/m per m of thickness, for slip away from the start
  std::array<double, 2> reference{0, 0};  // m, slip in the step at which capacities hold
  std::array<double, 2> rise{0, 0};       // m, by which the dilation changed last
  std::array<double, 2> pressed{0, 0};    // N per m of thickness, normal force before that

  // Whether the slip of this step has moved the end up or down.
  [[nodiscard]] bool has_ridden(std::size_t end) const { return dilation[end] != -owed[end]; }
  // Normal gap above what the end has ridden up.
  [[nodiscard]] double normal_gap(int end) const { return gap(2 * end) - dilation[static_cast<std::size_t>(end)]; }
};

// Linear in its gaps, whatever they are: nothing to settle.
inline bool is_whole(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  return has_stress_rows(springs) || (!trial.broken[0] && !trial.broken[1]);
}

// The change of the forces by the rows active in `trial` when gaps change.
inline Vec4 force_change(const InterfaceSprings& springs, const Vec4& active, double coupling, const Vec4& gap_change) {
  Vec4 change = active.cwiseProduct(springs.stiffness).cwiseProduct(gap_change);
  if (coupling != 0) {
    const Eigen::Index other = coupled_row(springs);
    change(0) += coupling * gap_change(other);
    change(other) += coupling * gap_change(0);
  }
  return change;
}

}  // namespace dda
