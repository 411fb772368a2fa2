// When a projected stretch with a bond breaks under the forces of its points.
//
// Springs stand at the ends of an interface and carry half of it each: either end breaks by itself, with half of the
// strength. A projected stretch breaks as a whole, since its traction is known all along it:
//   tension  at the edge where it is largest. The traction is linear between the edges, N/l +- 6 M/l^2 as beam theory
//            has it, with the normal force N and the moment M of the stretch. A brittle bond that tears there has less
//            left to carry the same moment, so it tears on at once.
//   shear    of the whole stretch, |T| > c l - N tan(phi), as that of a block that slides. A moment shifts normal force
//            from one half to the other, and friction with it, but leaves their sum; and where bending pulls the edges
//            most no shear flows in a beam. So the strength goes over to the friction of a dry joint as c goes to 0.
//            Of |T|: what a block does that is stretched beside one that is not has opposite shear at both ends, which
//            must not count for nothing. No traction with the resultant T and the moment m about the middle of the
//            stretch (of shear times place) adds up to less than the larger of |T| and 2 |m|/l: that is what is judged.
//            It leaves alone what is only shared unevenly, as under a force on one end of a flat block.
#pragma once

#include "engine/contact/interface_state.h"
#include "engine/contact/interface_trial.h"

namespace dda {

// Breaks a projected stretch whose forces are beyond its strength, of which either end has half; returns whether it
// did.
bool break_stretch(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

}  // namespace dda
