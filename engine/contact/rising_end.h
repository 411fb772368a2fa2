// An end that rides up as it slides (dilation), answered at once: normal force, shear force and slip of the step follow
// from one another, and from both gaps.
//
// With the slip s of the step towards the side of the tangential gap, D(s) what the end rides up by it, p the pressure
// and mu the friction,
//   p = k_n max(0, D(s) - g_n)     shear = k_s (|g_t| - s) = c + mu p     s >= 0
// which on the way out, where D grows, has one solution for any gaps, and is continuous in them. On the way back to
// where the end began D falls, and where mu tan(psi) k_n > k_s the pressure lets go of the shear faster than the
// spring: at given gaps there is then no solution on the way back, or two. So from three quarters of that on an end
// that slides back keeps its height for the step and comes down by it in the next (`owed`): what it rests on follows,
// and there is one answer again. Beside dashpots k_n and k_s are those of both together, and gaps count from where
// those would rest.
//
// Under integrators that conserve energy p is the mean pressure of the step, whose work is the change of the springs'
// energy (interface_trial.h), at the normal gap less D; the spring ends the step with what is left of its shear by
// that,
//   p = (V(g_n1 - D(s)) - V(g_n0))/(g_n0 - (g_n1 - D(s)))     k_s (|g_t| - s) = c + mu p     s >= 0
// while the mean of the shear is at most c + mu p on its own account. p grows with D and is convex in it, so there is
// again one slip on the way out. It is above 0 in a step in which the end opens, too: such an end rises and slips
// by its share of the step, and what it answers is continuous there.
//
// An end that was open when the step began rides up from the next step on: of its tangential motion nobody knows how
// much was in contact, and the same gaps would have two answers, with and without the rise.
#pragma once

#include <array>
#include <cstddef>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/contact/interface_trial.h"
#include "engine/core/types.h"

namespace dda {

// The end of this trial is answered so: it has no bond, touched at the start of the step, and its joint dilates. Not
// where capacities are given.
[[nodiscard]] bool rides_up(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                            int end);

// By how much ends have come down that have not been lowered yet, m.
[[nodiscard]] std::array<double, 2> height_owed(const InterfaceSprings& springs, const EndStrength& strength,
                                                const InterfaceState& state);

// What an end that slips by `slip` (m) in the step rises by in it, m, with what it owed.
[[nodiscard]] double rise_in_step(const InterfaceSprings& springs, const EndStrength& strength,
                                  const InterfaceTrial& trial, int end, double slip);

// Forces, dilation, capacity and active rows of such an end at the trial's gap. The rows are those of a joint that
// slips as steeply as it rises (associated flow), which is symmetric and leaves the way up its slope free. Of a lone
// vertex that takes the coupling of both rows; ends of stretches leave it to the slopes below.
void respond_riding(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial);

// The active rows of such an end that slid when the step began, and slides on.
void take_riding_rows(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial);

// Slopes of the forces (normal, shear) over the gaps (normal, tangential) beyond those of the active rows, of such an
// end that slides, or that rises while the mean of its shear sticks; `side`: 1 or -1, which way it is sheared. N/m per
// m of thickness.
[[nodiscard]] Mat2 slopes_beyond_rows(const InterfaceSprings& springs, const EndStrength& strength,
                                      const InterfaceTrial& trial, int end, double side);

}  // namespace dda
