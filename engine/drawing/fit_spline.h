// Curves through points, as drawing programs keep splines of which only fit points were given.
#pragma once

#include <optional>
#include <vector>

#include "engine/drawing/drawn_curve.h"

namespace dda {

// How a curve through points begins and ends: with a velocity, d point / d parameter; else with no second derivative. A
// closed one has neither.
struct FitEnds {
  std::optional<Vec2> start, end;
  bool closed = false;  // the last point is the first again
};

// The piecewise cubic with continuous second derivatives that is at points[i] for the parameter parameters[i] (cubic
// spline interpolation: C. de Boor, A Practical Guide to Splines, 1978, chapter IV). At least two points, of a closed
// curve four; parameters increase.
BSpline cubic_through(const std::vector<Vec2>& points, const std::vector<double>& parameters, const FitEnds& ends);

// The same with the lengths of the chords between the points as parameter, so that velocities have the size 1: of
// `ends` only the directions count. Points that repeat the one before are passed over, and a closed curve goes back to
// the first. Nothing where fewer than two different points are left, or of a closed curve three.
std::optional<BSpline> fit_spline(const std::vector<Vec2>& points, FitEnds ends);

}  // namespace dda
