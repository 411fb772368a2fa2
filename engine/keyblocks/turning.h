// Whether the faces that a body is pressed on can balance the moments as well, or it also turns.
#pragma once

#include "engine/keyblocks/first_motion.h"
#include "engine/keyblocks/rock_bodies.h"

namespace dda {

// What acts on a body, per m of thickness.
struct Resultant {
  Vec2 force = Vec2::Zero();  // N
  double moment = 0;          // N m, about the body's centroid
};

// True where no pressures and frictions on its faces keep the body from turning. Block theory leaves that out, so what
// it says of such a body may be on the unsafe side. Cohesion is not counted on. False for what falls freely.
bool turns(const RockBody& body, const Resultant& acting, const FirstMotion& motion);

}  // namespace dda
