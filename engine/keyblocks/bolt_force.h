// The force that bolts must be able to pull a body with, so that it has a wanted factor of safety F.
//
// Bolts are passive: they pull with what is needed, up to this force. It is enough when it holds the body
// 1. under what acts, with joints of F times less friction and cohesion, and
// 2. under F times what acts, with joints as they are,
// which are the two combinations that EN 1997-1 (2.4.7.3.4.2, design approach 1) asks for: a factor on the strength of
// the ground, and one on what acts. Where joints carry, the first decides: it is the factor of safety, resistance over
// drive. Where bolts carry alone it knows no factor, for there is no drive left that one could be of; then the second
// makes it F times the weight of a block that falls (Hoek and Brown 1980: N bolts of B hold W when N B = F W).
#pragma once

#include <optional>
#include <span>

#include "engine/keyblocks/joint_face.h"

namespace dda {

// N per m of thickness, in the unit vector `direction`, besides what acts already. 0 when none is needed; nothing when
// no force in this direction is enough.
std::optional<double> bolt_force(std::span<const JointFace> faces, const Vec2& force, const Vec2& direction,
                                 double wanted);

// The smallest force of any direction, as a vector. There always is one: it can carry all that acts.
Vec2 least_bolt_force(std::span<const JointFace> faces, const Vec2& force, double wanted);

}  // namespace dda
