// What one interface answers to a gap, and when it breaks: the laws of the open-close iteration.
//
// An end that is whole is linear in both directions. A broken (or dry) end presses only, and resists shear up to its
// `capacity`. For given capacities the answer is the gradient of a convex potential (a half parabola and Huber's
// function), so a step has exactly one solution and Newton's method with a line search finds it in finitely many
// passes; capacities then follow the normal forces (Coulomb as a fixed point of Tresca), and ends beyond their strength
// break.
#pragma once

#include <array>

#include "dda/contact/interface_element.h"
#include "dda/contact/interface_state.h"
#include "dda/core/types.h"

namespace dda {

// An interface in the course of a step.
struct InterfaceTrial {
  Vec4 gap = Vec4::Zero();               // m, at the displacements reached so far; tangential without earlier slip
  Vec4 direction = Vec4::Zero();         // m, its change along the full Newton step
  Vec4 force = Vec4::Zero();             // N per m of thickness, at `gap`
  Vec4 active = Vec4::Ones();            // 1 for rows that carry stiffness, 0 for open or sliding ones
  std::array<double, 2> capacity{0, 0};  // N per m of thickness, largest shear force of a broken end
  std::array<bool, 2> broken{false, false};
};

// Linear in its gaps, whatever they are: nothing to settle.
inline bool is_whole(const InterfaceElement& element, const InterfaceTrial& trial) {
  return has_stress_rows(element) || (!trial.broken[0] && !trial.broken[1]);
}

// Starts a step: gaps, capacities and broken ends of its first moment.
InterfaceTrial start_trial(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& start);

// Force and active rows at the trial's gap. Classical elements only; the others are linear and never ask.
void respond(const InterfaceElement& element, InterfaceTrial& trial);

// Work rate direction . force at a share `t` of the Newton step.
double force_along(const InterfaceElement& element, const InterfaceTrial& trial, double t);

// Sets capacities to friction times normal force; returns the largest change of a force that this makes at this gap.
double update_capacity(const InterfaceElement& element, const EndStrength& strength, InterfaceTrial& trial);

// Breaks ends that are beyond their strength; returns whether one broke.
bool break_ends(const EndStrength& strength, InterfaceTrial& trial);

// The state that a converged trial leaves.
InterfaceState finish_trial(const InterfaceElement& element, const InterfaceState& start, const InterfaceTrial& trial);

// True when an interface with stress rows is loaded beyond the strength of its joint and must go on as a classical one:
// when either end, with its share of the normal force and of the moment, and half the shear force, is.
bool beyond_strength(const EndStrength& strength, const Vec4& force);

}  // namespace dda
