#include "engine/drawing/drawn_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/geometry/box.h"

namespace dda {
namespace {

constexpr double coarsest = 0.1;  // chord tolerance as a share of the size: a circle keeps at least 8 corners

Vec2 left_of(const Vec2& vector) { return {-vector.y(), vector.x()}; }

// Half the larger axis of the ellipse u cos t + v sin t.
double larger_half_axis(const Vec2& u, const Vec2& v) {
  const double sum = u.squaredNorm() + v.squaredNorm();
  const double area = u.x() * v.y() - u.y() * v.x();
  return std::sqrt((sum + std::sqrt(std::max(0.0, (sum - 2 * area) * (sum + 2 * area)))) / 2);
}

// de Boor's recurrence in homogeneous coordinates, on the span between knots `span` and `span` + 1.
Vec2 spline_point(const BSpline& spline, std::size_t span, double t) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  std::vector<Vec3> net;
  for (std::size_t i = span - degree; i <= span; ++i) {
    const double weight = spline.weights[i];
    net.emplace_back(weight * spline.points[i].x(), weight * spline.points[i].y(), weight);
  }
  for (std::size_t level = 1; level <= degree; ++level) {
    for (std::size_t i = degree; i >= level; --i) {
      const double low = spline.knots[span - degree + i];
      const double high = spline.knots[span + 1 + i - level];
      const double share = high > low ? (t - low) / (high - low) : 0;
      net[i] = (1 - share) * net[i - 1] + share * net[i];
    }
  }
  return net[degree].head<2>() / net[degree].z();
}

// The largest second difference at a fine step; the spans of splines are smooth.
double sampled_bend(const DrawnCurve& curve) {
  constexpr int steps = 32;
  constexpr double margin = 1.25;  // for what lies between the samples
  const double step = (curve.to - curve.from) / steps;
  double most = 0;
  for (int i = 1; i < steps; ++i) {
    const double t = curve.from + i * step;
    most = std::max(most, (curve.at(t - step) - 2 * curve.at(t) + curve.at(t + step)).norm());
  }
  return margin * most / (step * step);
}

double squared_distance(const DrawnCurve& curve, double parameter, const Vec2& point) {
  return (curve.at(parameter) - point).squaredNorm();
}

// Returns the parameter between the two at which the curve is nearest to `point`, by golden sections.
double nearest_between(const DrawnCurve& curve, double low, double high, const Vec2& point) {
  constexpr double golden = 1 / std::numbers::phi;
  constexpr int sections = 60;  // 0.618^60 = 3e-13 of the stretch
  for (int i = 0; i < sections; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    if (squared_distance(curve, a, point) < squared_distance(curve, b, point))
      high = b;
    else
      low = a;
  }
  return (low + high) / 2;
}

double side_of(const DrawnCurve& curve, double parameter, const Vec2& start, const Vec2& along) {
  const Vec2 way = curve.at(parameter) - start;
  return along.x() * way.y() - along.y() * way.x();
}

// Returns the parameter between two on either side of a line at which the curve crosses it, by halving.
double crossing_between(const DrawnCurve& curve, double low, double high, const Vec2& start, const Vec2& along) {
  constexpr int halvings = 52;  // all digits
  const bool is_left = side_of(curve, low, start, along) > 0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    ((side_of(curve, middle, start, along) > 0) == is_left ? low : high) = middle;
  }
  return (low + high) / 2;
}

// Whether `end` lies within `reach` of the curve around a parameter, on the side to which the curve bends there.
bool is_beside_chord(const DrawnCurve& curve, double parameter, double step, const Vec2& end, double reach) {
  const Vec2 place = curve.at(parameter);
  const Vec2 inwards = curve.at(parameter - step / 2) + curve.at(parameter + step / 2) - 2 * place;
  if (inwards.dot(end - place) <= 0) return false;
  const double nearest = nearest_between(curve, parameter - step, parameter + step, end);
  return squared_distance(curve, nearest, end) <= reach * reach;
}

}  // namespace

DrawnCurve elliptic_arc(const Vec2& centre, const Vec2& u, const Vec2& v, double from, double to) {
  const double half_axis = larger_half_axis(u, v);
  const auto at = [=](double t) -> Vec2 { return centre + std::cos(t) * u + std::sin(t) * v; };
  return {at, from, to, half_axis, half_axis};
}

DrawnCurve bulge_arc(const Vec2& start, const Vec2& end, double bulge, const Mat2& turn, const Vec2& shift) {
  const Vec2 centre = (start + end) / 2 + (1 - bulge * bulge) / (4 * bulge) * left_of(end - start);
  const Vec2 u = start - centre;
  const Vec2 v = std::copysign(1.0, bulge) * left_of(u);
  return elliptic_arc(turn * centre + shift, turn * u, turn * v, 0, 4 * std::atan(std::abs(bulge)));
}

std::vector<DrawnCurve> spans_of(const BSpline& spline) {
  Box box;
  for (const Vec2& point : spline.points) box = expanded(box, point);
  const auto shared = std::make_shared<const BSpline>(spline);
  std::vector<DrawnCurve> spans;
  for (auto span = static_cast<std::size_t>(spline.degree); span < spline.points.size(); ++span) {
    if (!(spline.knots[span] < spline.knots[span + 1])) continue;
    DrawnCurve curve;
    curve.at = [shared, span](double t) { return spline_point(*shared, span, t); };
    curve.from = spline.knots[span];
    curve.to = spline.knots[span + 1];
    curve.bend = sampled_bend(curve);
    curve.size = (box.upper - box.lower).norm() / 2;
    spans.push_back(std::move(curve));
  }
  return spans;
}

double allowed_beside(const DrawnCurve& curve, const ChordTolerance& tolerance) {
  const double wanted = tolerance.length > 0 ? tolerance.length : tolerance.share * curve.size;
  return std::min(wanted, coarsest * curve.size);
}

double chords_needed(const DrawnCurve& curve, double from, double to, const ChordTolerance& tolerance) {
  const double allowed = allowed_beside(curve, tolerance);
  if (!(allowed > 0)) return 1;
  constexpr double round_off = 1e-9;
  return std::max(1.0, std::ceil((to - from) * std::sqrt(curve.bend / (8 * allowed)) - round_off));
}

double parameter_near(const DrawnCurve& curve, const Vec2& point, double reach) {
  constexpr int samples = 32;
  const double step = (curve.to - curve.from) / samples;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double squared = squared_distance(curve, curve.from + i * step, point);
    if (squared < least) {
      least = squared;
      best = i;
    }
  }
  const double low = std::max(curve.from, curve.from + (best - 1) * step);
  const double high = std::min(curve.to, curve.from + (best + 1) * step);
  const double nearest = nearest_between(curve, low, high, point);
  const auto within = [&](double parameter) { return (curve.at(parameter) - point).norm() <= reach; };
  return within(nearest) && !within(curve.from) && !within(curve.to) ? nearest : std::nan("");
}

double parameter_crossed(const DrawnCurve& curve, const Vec2& end, const Vec2& other, double reach) {
  constexpr int samples = 64;
  const double step = (curve.to - curve.from) / samples;
  const Vec2 along = other - end;
  double found = std::nan("");
  double least = along.squaredNorm();
  for (int i = 0; i < samples; ++i) {
    const double low = curve.from + i * step;
    if ((side_of(curve, low, end, along) > 0) == (side_of(curve, low + step, end, along) > 0)) continue;
    const double crossing = crossing_between(curve, low, low + step, end, along);
    const double way = along.dot(curve.at(crossing) - end);
    if (way <= 0 || way >= least || !is_beside_chord(curve, crossing, step, end, reach)) continue;
    found = crossing;
    least = way;
  }
  return found;
}

}  // namespace dda
