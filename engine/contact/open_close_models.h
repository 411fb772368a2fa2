// For tests: one interface with two ends, taken to given gaps.
#pragma once

#include "engine/contact/open_close.h"

namespace dda {

inline constexpr double normal_spring = 100;
inline constexpr double shear_spring = 40;
inline constexpr double round_off = 1e-13;

inline InterfaceElement classical_element() {
  InterfaceElement element;
  element.law = InterfaceLaw::classical;
  element.length = 2;
  element.stiffness << normal_spring, shear_spring, normal_spring, shear_spring;
  return element;
}

// The answer at given gaps when capacities and dilations stand still and nothing more breaks.
inline void settle(const InterfaceElement& element, const EndStrength& strength, InterfaceTrial& trial) {
  do {
    respond(element, trial);
    for (int pass = 0; pass < 80; ++pass) {
      update_capacity(element, strength, trial);
      update_dilation(element, strength, trial);
    }
  } while (break_ends(element, strength, trial));
}

// One step that takes the end `from` to the given gaps while `to` is pressed.
inline InterfaceState step_to(const EndStrength& strength, InterfaceState start, double normal_gap, double shear_gap) {
  start.gap(2) = -1;
  start.force(2) = -normal_spring;
  InterfaceTrial trial = start_trial(classical_element(), strength, start);
  trial.gap << normal_gap, shear_gap, -1, 0;
  settle(classical_element(), strength, trial);
  return finish_trial(classical_element(), start, trial);
}

inline InterfaceState start_with(bool broken, ContactStatus status = ContactStatus::locked) {
  InterfaceState start;
  start.broken[0] = broken;
  start.status[0] = status;
  return start;
}

inline constexpr ContactStatus locked = ContactStatus::locked;
inline constexpr ContactStatus sliding = ContactStatus::sliding;
inline constexpr ContactStatus open = ContactStatus::open;

// Peak friction 0.5, residual 0.3; the bond leaves a cohesion of 0.6.
inline const EndStrength weakening{
    .tension = 5, .cohesion = 3, .friction = 0.5, .residual_cohesion = 0.6, .friction_drop = 0.2};
inline const EndStrength dry_weakening{.friction = 0.5, .friction_drop = 0.2};

}  // namespace dda
