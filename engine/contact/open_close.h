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

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/contact/interface_trial.h"
#include "engine/core/types.h"

namespace dda {

// Starts a step: gaps, capacities and broken ends of its first moment.
InterfaceTrial start_trial(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& start,
                           const ContactRule& rule = {});

// Force and active rows at the trial's gap. Not for elements with stress rows, which are linear and never ask.
void respond(const InterfaceSprings& springs, InterfaceTrial& trial);

// Work rate direction . force at a share `t` of the Newton step.
double force_along(const InterfaceSprings& springs, const InterfaceTrial& trial, double t);

// Shear of an end that does not slide, whatever its capacity.
void respond_as_stuck(const InterfaceSprings& springs, int end, InterfaceTrial& trial);

// respond() with the capacities of the normal forces there, unless they are given, and with dilations of the slips
// there where rising_end.h has an answer.
void respond_with_friction(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Sets capacities to those of the normal forces, unless they are given; returns the largest change of a force that this
// makes at this gap.
double update_capacity(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Sets dilations to those of the slips; returns the largest change of a force that this makes at this gap. For
// capacities that stand still.
double update_dilation(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// Back to an end that has not ridden up in the step; what it answers is not brought up to date.
void forget_rise(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

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
