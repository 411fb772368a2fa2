// Curves of a drawing, and the chords that stand for them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/core/types.h"

namespace dda {

// A curve by its parameter, which grows from `from` to `to`.
struct DrawnCurve {
  std::function<Vec2(double)> at;
  double from = 0;
  double to = 1;
  double bend = 0;  // m, upper bound of |d2 at / d parameter2|, by which chords leave the curve
  double size = 0;  // m: radius, larger half axis, or half the diagonal of what holds it
};

// centre + u cos t + v sin t: circles and ellipses, however they are turned and scaled.
DrawnCurve elliptic_arc(const Vec2& centre, const Vec2& u, const Vec2& v, double from, double to);

// The arc from `start` to `end` with this bulge: the tangent of a quarter of the angle it turns by, positive when
// counter-clockwise; put in place by p -> turn p + shift. `bulge` is not 0.
DrawnCurve bulge_arc(const Vec2& start, const Vec2& end, double bulge, const Mat2& turn, const Vec2& shift);

// A rational B-spline. There are knots of degree + 1 more than control points, which do not decrease, and as many
// weights above 0 as control points. One curve for each span of knots that has a length, from start to end.
struct BSpline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec2> points;
  std::vector<double> weights;
};
std::vector<DrawnCurve> spans_of(const BSpline& spline);

// How far chords may leave curves: the same everywhere, or by the size of each.
struct ChordTolerance {
  double length = 0;    // m; 0: by the share
  double share = 0.01;  // of the size
};

// m, by how much chords may leave this curve.
double allowed_beside(const DrawnCurve& curve, const ChordTolerance& tolerance);

// The number of equal steps of the parameter from `from` to `to` that keeps chords within the tolerance. Over a step h
// they leave the curve by bend h^2/8 at most.
double chords_needed(const DrawnCurve& curve, double from, double to, const ChordTolerance& tolerance);

// The parameter, not at an end, at which the curve comes within `reach` (m) of the point; NaN where it does not.
double parameter_near(const DrawnCurve& curve, const Vec2& point, double reach);

// The parameter at which a straight line that comes from `other` crosses the curve, where it ends at `end` soon after:
// on the side of the chords and within `reach` (m) of the curve. NaN where it does not.
double parameter_crossed(const DrawnCurve& curve, const Vec2& end, const Vec2& other, double reach);

}  // namespace dda
