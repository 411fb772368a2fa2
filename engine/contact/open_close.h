// What one interface answers to a gap, and when it breaks: the laws of the open-close iteration.
//
// An end that is whole is linear in both directions. A broken (or dry) end presses only, and resists shear up to its
// `capacity`. For given capacities and dilations the answer is the gradient of a convex potential (a half parabola and
// Huber's function), so a step has exactly one solution and Newton's method with a line search finds it in finitely
// many passes; capacities then follow the normal forces (Coulomb as a fixed point of Tresca), dilations the slips, and
// ends beyond their strength break.
//
// Dilation presses an end that slides on against what lies above it, by up to its normal stiffness times the rise. Left
// to the outer fixed point alone, which first lets the end slide as if nothing rose, that would be overshot without
// bound. So the capacity grows with the slip beyond the one at which it holds, by `hardening`, which keeps the problem
// convex and is of no effect where the fixed point ends. The first guess of it, with the full normal stiffness, never
// overshoots; the next follow the changes of the normal force seen.
#pragma once

#include <array>
#include <cstddef>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
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
  double coupling = 0;                   // N/m per m of thickness, of either normal force by the gap of the other end
  Vec4 before = Vec4::Zero();            // N per m of thickness, of the start, where the balance takes means with it
  std::array<double, 2> capacity{0, 0};  // N per m of thickness, largest shear force of a broken end; with `before`
  std::array<bool, 2> broken{false, false};
  std::array<bool, 2> residual{false, false};
  ContactRule rule;

  std::array<double, 2> slip{0, 0};       // m, before the step
  std::array<double, 2> dilation{0, 0};   // m, in the step: the normal gap closes at it
  std::array<double, 2> hardening{0, 0};  // N/m per m of thickness, for slip away from the start
  std::array<double, 2> reference{0, 0};  // m, slip in the step at which capacities hold
  std::array<double, 2> rise{0, 0};       // m, by which the dilation changed last
  std::array<double, 2> pressed{0, 0};    // N per m of thickness, normal force before that

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
    change(0) += coupling * gap_change(2);
    change(2) += coupling * gap_change(0);
  }
  return change;
}

// Starts a step: gaps, capacities and broken ends of its first moment.
InterfaceTrial start_trial(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& start,
                           const ContactRule& rule = {});

// Force and active rows at the trial's gap. Not for elements with stress rows, which are linear and never ask.
void respond(const InterfaceSprings& springs, InterfaceTrial& trial);

// Work rate direction . force at a share `t` of the Newton step.
double force_along(const InterfaceSprings& springs, const InterfaceTrial& trial, double t);

// Shear of an end that does not slide, whatever its capacity.
void respond_as_stuck(const InterfaceSprings& springs, int end, InterfaceTrial& trial);

// respond() with the capacities of the normal forces there, unless they are given.
void respond_with_friction(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Sets capacities to those of the normal forces, unless they are given; returns the largest change of a force that this
// makes at this gap.
double update_capacity(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Sets dilations to those of the slips; returns the largest change of a force that this makes at this gap. For
// capacities that stand still.
double update_dilation(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Breaks ends that are beyond their strength, and leaves dry ends that slide their residual friction; returns whether
// there was one. Each end does both once. A projected stretch breaks as a whole.
bool break_ends(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// The part of a trial's force that comes from dashpots.
Vec4 dashpot_force(const InterfaceSprings& springs, const InterfaceTrial& trial);

// Lets shear beyond the friction of a closed, broken end go (after a stage in which contacts stuck). Returns whether
// something changed; the slip takes what the gap loses.
bool release_shear(const InterfaceSprings& springs, const EndStrength& strength, InterfaceState& state);

// The state that a converged trial leaves: forces of the springs alone.
InterfaceState finish_trial(const InterfaceSprings& springs, const InterfaceState& start, const InterfaceTrial& trial);

}  // namespace dda
