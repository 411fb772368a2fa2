// When a projected stretch with a bond breaks under the forces of its points, and what that leaves of its strength.
//
// Springs stand at the ends of an interface and carry half of it each: either end breaks by itself, with half of the
// strength. A projected stretch breaks as a whole, since its traction is known all along it:
//   tension  at the edge where it is largest. The traction is linear between the edges, N/l +- 6 M/l^2 as beam theory
//            has it, with the normal force N and the moment M of the stretch. A brittle bond that tears there has less
//            left to carry the same moment, so it tears on at once, until what is left presses: where nothing does, all
//            of the bond is gone.
//   shear    of the whole stretch, |T| > c l - N tan(phi), as that of a block that slides. A moment shifts normal force
//            from one half to the other, and friction with it, but leaves their sum; and where bending pulls the edges
//            most no shear flows in a beam. So the strength goes over to the friction of a dry joint as c goes to 0.
//            A block that is stretched beside one that is not, as by its Poisson's ratio under its weight, has opposite
//            shear at both ends. No traction with the resultant T and the moment m about the middle of the stretch (of
//            shear times place) adds up to less than the larger of |T| and 2 |m|/l. Where the latter is beyond the
//            strength the ends slide against each other, as far as the block is strained, and nothing goes anywhere. So
//            a stretch that presses yields there: its ends carry what they can, together as much as before, and it has
//            failed when it slides as a whole, as limit equilibrium has it. One that does not press has failed.
//            What is only shared unevenly is left alone, as under a force on one end of a flat block.
//
// A stretch that is torn at an edge, or yields, and presses carries no tension any more, and keeps the peak strength in
// shear where it has never gaped: c l' - N tan(phi), l' what is left of the length when the farthest that either edge
// has gaped is taken off (`torn`). When it slides or opens as a whole it has failed, and has its residual strength
// where it is closed. Either point has of the cohesion what it has of the pressure, so none is lost when an edge gapes
// so far that one of the points no longer presses.
#pragma once

#include <array>

#include "engine/contact/interface_state.h"
#include "engine/contact/interface_trial.h"

namespace dda {

// Breaks a projected stretch whose forces are beyond its strength, of which either end has half, or leaves one that is
// torn and no longer holds, or dry and slides, its residual strength; returns whether it did either.
bool break_stretch(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial);

// The largest shear force of an end of a stretch that is broken or dry, N per m of thickness: between steps, and in the
// course of one, where it is twice that of the mean force if the balance takes means.
double stretch_capacity(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& state,
                        int end);
double stretch_capacity(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                        int end);

// How the latter follows the normal gaps of both points, N/m per m of thickness, by how the normal forces of the points
// (rows of `by_gaps`) do.
Vec2 stretch_capacity_by_gaps(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                              const Mat2& by_gaps, int end);

// Notes at the end of a step how far a stretch that keeps its peak strength has torn. Without cohesion it has nothing
// to lose by that, and need not be asked.
void note_torn(const InterfaceSprings& springs, InterfaceState& state);

}  // namespace dda
