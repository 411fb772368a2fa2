// Prescribed motion: a history that stands for a displacement, a velocity or an acceleration, and the other two that
// belong to it.
#pragma once

#include "engine/model/time_function.h"

namespace dda {

enum class MotionKind { displacement, velocity, acceleration };

// Factors of one amplitude. With a displacement amplitude D the motion is D displacement, D velocity, D acceleration;
// with one of velocity or acceleration it is the integral, from rest at t = 0, of what is prescribed.
struct MotionFactors {
  double displacement = 0;
  double velocity = 0;
  double acceleration = 0;
};

// Exact for every history but for round-off. Where a displacement or velocity jumps, or a displacement has a kink, the
// impulse is left out of the derivatives; at a kink they are those to its right.
MotionFactors motion_at(MotionKind kind, const TimeFunction& history, double time);

}  // namespace dda
