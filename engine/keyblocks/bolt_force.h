// The force that a bolt must pull a body with, so that it has a wanted factor of safety.
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
