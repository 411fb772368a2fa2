// How far the wall of an opening overshoots when its rock is taken out, by how long what the rock exerted takes to
// fade.
//
// A round opening of radius a in elastic rock in plane strain, under the same stress from all sides: the pressure on
// its wall goes to nothing along a straight line over a time T. In the Laplace transform of time t c_p/a the wall's
// displacement after a sudden removal, over what it settles to, is
//   U(z) = 1/(z (1 + m z K0(z)/K1(z))),  m = (lambda + 2 G)/(2 G)
// from the outgoing wave A K0(z r/a) of the potential whose gradient the displacement is, with the traction
// (lambda + 2 G) div u - 2 G u/r on the wall. A ramp's response is the mean of the step's over the time T before. Both
// come back by the formula of Stehfest (1970) with 14 terms, to 1e-3 of what the wall settles to.
#pragma once

#include <cstddef>
#include <string>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// The largest displacement of the wall over what it settles to, less 1. `modulus_ratio`: m above, at least 1/2; `ramp`:
// T c_p/a, 0 for a sudden removal.
double wall_overshoot(double modulus_ratio, double ramp);

// The shortest ramp, T c_p/a, that leaves no more than this much of it; 0 where a sudden removal has less.
double least_ramp(double modulus_ratio, double overshoot);

// A sentence for a dynamic stage that removes blocks: what the wall is to overshoot by, and the ramps that leave 5 %
// and 1 %; empty for other stages. The largest of the openings counts, as a round one of its area in the rock as it is
// in that stage.
std::string ramp_of_removal(const Model& model, const ContactSet& contacts, std::size_t stage_index);

}  // namespace dda
