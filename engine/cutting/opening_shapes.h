// Outlines of openings. Arcs become chords that leave them by `chord_tolerance` (m) at most; corners lie on the arc.
#pragma once

#include "engine/geometry/polygon.h"

namespace dda {

Ring circle(const Vec2& centre, double radius, double chord_tolerance);

// On a level floor of which `foot` is the middle.
Ring rectangle(const Vec2& foot, double width, double height);

// Upright walls below a roof that is an arc of a circle and rises by `rise`, at most half of the width.
Ring arch(const Vec2& foot, double width, double height, double rise, double chord_tolerance);

// A roof that is half a circle on walls that are arcs about the opposite springing, so that the floor is narrower than
// the opening. `height` lies between half the width, without walls, and 1.366 of it, where the walls would meet.
Ring horseshoe(const Vec2& foot, double width, double height, double chord_tolerance);

inline constexpr double most_horseshoe = 1.36;  // of height to width

}  // namespace dda
