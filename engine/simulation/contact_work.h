// What contacts take of the energy of a step.
#pragma once

#include <limits>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"

namespace dda {

// m, of an interface in a step: of all, and how much of it held blocks make, whose motion is prescribed.
struct GapChange {
  Vec4 all, held;
};

// What an interface works with in a step beside the forces that its states before and after keep.
struct WorkingForces {
  Vec4 extra;  // what the balance had beyond that of `after`, times the weight of forces at the end of the step
  // By its strength, N per m of thickness. Where another edge becomes the one that a vertex presses, what was normal
  // force is shear in part, of which friction may hold little or nothing: it is let go, which friction does not do.
  double most_friction;
  // How far (as a share of a step) behind the middle of the step the moment lies to which its balance belongs. A
  // dashpot has the force of the velocity in that middle and acts at that moment, by this share already in the motion
  // of the step that follows: where blocks meet, its first force is one of full speed on half of the way.
  double dashpot_delay;
  // By the shear at the end of the step of the ends that slip, N per m of thickness; asked for in static steps alone.
  double friction_at_end = std::numeric_limits<double>::infinity();
};

// J per m of thickness.
struct ContactWork {
  // By what moves held blocks against forces that the balance had but no state keeps, and off it what the mean of a
  // step takes for the work of a force that a held block let go early in it.
  double brought = 0;
  double friction = 0, dashpot = 0, numerical = 0;
  double friction_beyond_end = 0;  // what of the friction is more than friction_at_end takes

  // Work of friction and of dashpots on one interface, and what status changes within the step make of it.
  void changed(const InterfaceElement& element, const InterfaceState& before, const InterfaceState& after,
               const GapChange& gap_change, const WorkingForces& forces);

  ContactWork& operator+=(const ContactWork& more) {
    brought += more.brought;
    friction += more.friction;
    dashpot += more.dashpot;
    numerical += more.numerical;
    friction_beyond_end += more.friction_beyond_end;
    return *this;
  }
};

}  // namespace dda
