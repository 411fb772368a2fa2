// Newmark's sliding block (Newmark 1965): a rigid block on a plane whose acceleration is a record of samples with
// straight lines between them, under Coulomb friction.
//
// Between two samples the acceleration of a sliding block is linear in time, its velocity a parabola: where a slip
// ends, and where one begins, are roots of a quadratic and of a line, and every phase integrates in closed form. No
// time step.
#pragma once

#include "verification/exact/base_motion.h"

namespace exact {

struct SlidingPlane {
  double gravity = 0;   // m/s2
  double slope = 0;     // rad
  double friction = 0;  // tangent of the friction angle, not below that of the slope
};

// Motion relative to the plane at `time` (s), down the slope positive, of a block at rest at the record's start. The
// record is the horizontal acceleration that the block feels, m/s2, downhill positive: that of the plane is the
// opposite.
[[nodiscard]] BaseMotion slide_on_record(const SlidingPlane& plane, const Accelerogram& record, double time);

}  // namespace exact
