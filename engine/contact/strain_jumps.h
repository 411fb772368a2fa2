// How far the ends of stretches lie beside each other only because the blocks along them are strained unequally.
//
// A joint that sticks holds its blocks together in the mean of its length. Where one of them is strained along it and
// the other is not, as beside the corner of an opening, its ends slide in and out by half of the difference, and the
// corners of blocks across a crossing of joints come to lie in each other by as much: rock that is one piece has no
// such steps. They are no way that blocks have moved against each other, and make no contact (covered_corners.h).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/interface_element.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// That of a stretch, m: half of what its ends have gone along it against each other, and of what they have across it
// where nothing gapes. There the difference is how the rock bends; where a joint gapes its blocks have turned.
double strain_jump(const InterfaceFrame& frame, bool gapes);

// The largest jump of a block's stretches that end beside `place`, by no more than the jump and `near` (m), when
// increments `d` (6 a block) have moved and strained the blocks of `state`; 0 where none does. Asks all contacts.
double strain_jump_at(int block, const Vec2& place, double near, const Model& model, const State& state,
                      const ContactSet& contacts, const Eigen::VectorXd& d);

}  // namespace dda
