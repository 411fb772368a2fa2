// Parts of scenes that the sections of chapters 5 and 6 share: joint sets, the hole of a blast, supports while rock
// settles, measurements.
#pragma once

#include <string>

#include "engine/core/types.h"
#include "verification/chapters/scene_runs.h"

namespace verify {

struct JointSet {
  double dip = 0;    // deg, counter-clockwise from +x
  double shift = 0;  // of its first line from the origin, in spacings, across its direction
};

[[nodiscard]] SceneFolder::Scene joint_set(const std::string& name, const JointSet& set, double spacing);

// The hole of a blast around (x, 0): edges of 1 m, upright and level ones among them.
constexpr double octagon_half_width = 1.20710678118654752;  // m, (1 + sqrt 2)/2
[[nodiscard]] SceneFolder::Scene octagon_around(double x);

// Across the base and, where they are held, the sides; else the base holds the rock level. In the stage "settle".
[[nodiscard]] SceneFolder::Scene held_while_settling(bool sides_held);

// Displacement, velocity and acceleration, PREFIX_QUANTITY_AXIS; `where` has "point" or "block".
void measure_motion(SceneFolder::Scene& list, const std::string& prefix, const SceneFolder::Scene& where);
// PREFIX_xx and PREFIX_yy.
void measure_stress(SceneFolder::Scene& list, const std::string& prefix, const dda::Vec2& point);

}  // namespace verify
