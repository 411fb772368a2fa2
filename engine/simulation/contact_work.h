// What contacts take of the energy of a step.
#pragma once

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"

namespace dda {

// J per m of thickness.
struct ContactWork {
  double brought = 0;  // by what moves held blocks against forces that the balance had but no state keeps
  double friction = 0, dashpot = 0, numerical = 0;

  // Work of friction and of dashpots on one interface, and what status changes within the step make of it.
  // `extra_force`: what the balance of the step had beyond the force that `after` keeps, times the weight of forces at
  // the end of the step. `dashpot_delay`: how far (as a share of a step) behind the middle of the step the moment lies
  // to which its balance belongs. A dashpot has the force of the velocity in that middle and acts at that moment, by
  // this share already in the motion of the step that follows: where blocks meet, its first force is one of full speed
  // on half of the way.
  void changed(const InterfaceElement& element, const InterfaceState& before, const InterfaceState& after,
               const Vec4& gap_change, const Vec4& extra_force, double dashpot_delay);

  ContactWork& operator+=(const ContactWork& more) {
    brought += more.brought;
    friction += more.friction;
    dashpot += more.dashpot;
    numerical += more.numerical;
    return *this;
  }
};

}  // namespace dda
