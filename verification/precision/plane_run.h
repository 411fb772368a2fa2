// A P and an S wave from a smooth source in the middle of a square plate of 160 m, read 30 m off in three directions
// until what its free edges send back could arrive.
#pragma once

#include "engine/model/model.h"
#include "verification/exact/plane_pulse.h"
#include "verification/precision/job.h"

namespace verify {

inline constexpr double plane_half_side = 80;    // m
inline constexpr double plane_duration = 0.025;  // s: P from the rim of the source off the edge and back at a receiver

[[nodiscard]] PrecisionResult run_plane(const PrecisionJob& job);

// Finished; an even number of blocks along a side. Its measurements are displacement_x and _y of the receivers: the
// centroids nearest to 30 m at 0, 22.5 and 45 degrees.
[[nodiscard]] dda::Model plane_model(const PrecisionJob& job);

[[nodiscard]] const exact::PlanePulse& plane_pulse();

// Exact displacement (m) at (x, y) from the source, at t = i dt: x and y.
struct PlaneHistory {
  std::vector<double> x, y;
};
[[nodiscard]] PlaneHistory exact_displacement(double x, double y, double dt, int samples);

}  // namespace verify
