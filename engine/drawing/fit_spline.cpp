#include "engine/drawing/fit_spline.h"

#include <cstddef>

#include "engine/geometry/box.h"

namespace dda {
namespace {

// Row i: before[i] x[i - 1] + middle[i] x[i] + after[i] x[i + 1] = right[i].
struct Rows {
  std::vector<double> before, middle, after;
  std::vector<Vec2> right;

  void add(double b, double m, double a, const Vec2& r) {
    before.push_back(b);
    middle.push_back(m);
    after.push_back(a);
    right.push_back(r);
  }
};

// By elimination from the first row on; the rows of splines have dominant middles, so nothing is exchanged.
std::vector<Vec2> solved(Rows rows) {
  const std::size_t count = rows.middle.size();
  for (std::size_t i = 1; i < count; ++i) {
    const double share = rows.before[i] / rows.middle[i - 1];
    rows.middle[i] -= share * rows.after[i - 1];
    rows.right[i] -= share * rows.right[i - 1];
  }
  std::vector<Vec2> x(count);
  for (std::size_t i = count; i-- > 0;)
    x[i] = (i + 1 < count ? Vec2(rows.right[i] - rows.after[i] * x[i + 1]) : rows.right[i]) / rows.middle[i];
  return x;
}

// With x[-1] the last and x[count] the first: the two corners are a matrix of rank one, taken off and put back by the
// formula of Sherman and Morrison (1950).
std::vector<Vec2> solved_in_a_circle(Rows rows) {
  const std::size_t last = rows.middle.size() - 1;
  const double first_corner = rows.before.front();  // of x[last] in the first row
  const double last_corner = rows.after.back();     // of x[0] in the last row
  const double pivot = -rows.middle.front();
  Rows sides = rows;
  sides.middle.front() -= pivot;
  sides.middle.back() -= first_corner * last_corner / pivot;
  Rows unit = sides;
  unit.right.assign(last + 1, Vec2::Zero());
  unit.right.front().setConstant(pivot);
  unit.right.back().setConstant(last_corner);
  std::vector<Vec2> x = solved(sides);
  const std::vector<Vec2> z = solved(unit);
  const double weight = first_corner / pivot;
  const Vec2 factor = (x.front() + weight * x.back()) / (1 + z.front().x() + weight * z.back().x());
  for (std::size_t i = 0; i <= last; ++i) x[i] -= z[i].cwiseProduct(factor);
  return x;
}

class Fit {
 public:
  Fit(const std::vector<Vec2>& points, const std::vector<double>& parameters) : points_(points), at_(parameters) {}

  // d point / d parameter at the points.
  [[nodiscard]] std::vector<Vec2> velocities(const FitEnds& ends) const {
    const std::size_t last = points_.size() - 1;
    Rows rows;
    if (ends.closed) {
      for (std::size_t i = 0; i < last; ++i) add_smooth_row(i == 0 ? last - 1 : i - 1, i, rows);
      std::vector<Vec2> closed = solved_in_a_circle(rows);
      closed.push_back(closed.front());
      return closed;
    }
    add_end_row(ends.start, 0, 0, 1, rows);
    for (std::size_t i = 1; i < last; ++i) add_smooth_row(i - 1, i, rows);
    add_end_row(ends.end, last - 1, 1, 0, rows);
    return solved(rows);
  }

 private:
  [[nodiscard]] double step(std::size_t piece) const { return at_[piece + 1] - at_[piece]; }
  [[nodiscard]] Vec2 slope(std::size_t piece) const { return (points_[piece + 1] - points_[piece]) / step(piece); }

  // The second derivative is the same at the end of one piece and the start of the next.
  void add_smooth_row(std::size_t piece, std::size_t next, Rows& rows) const {
    const double before = 1 / step(piece);
    const double after = 1 / step(next);
    rows.add(before, 2 * (before + after), after, 3 * (before * slope(piece) + after * slope(next)));
  }

  // The velocity is given, or the second derivative is zero.
  void add_end_row(const std::optional<Vec2>& velocity, std::size_t piece, double before, double after,
                   Rows& rows) const {
    if (velocity)
      rows.add(0, 1, 0, *velocity);
    else
      rows.add(before, 2, after, 3 * slope(piece));
  }

  const std::vector<Vec2>& points_;
  const std::vector<double>& at_;
};

}  // namespace

// Each piece by its Bezier points: knots in the middle count three times.
BSpline cubic_through(const std::vector<Vec2>& points, const std::vector<double>& parameters, const FitEnds& ends) {
  const std::vector<Vec2> velocities = Fit(points, parameters).velocities(ends);
  BSpline spline;
  spline.degree = 3;
  spline.knots.push_back(parameters.front());
  for (const double parameter : parameters) spline.knots.insert(spline.knots.end(), 3, parameter);
  spline.knots.push_back(parameters.back());
  spline.points.push_back(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double third = (parameters[i] - parameters[i - 1]) / 3;
    spline.points.emplace_back(points[i - 1] + third * velocities[i - 1]);
    spline.points.emplace_back(points[i] - third * velocities[i]);
    spline.points.push_back(points[i]);
  }
  spline.weights.assign(spline.points.size(), 1.0);
  return spline;
}

std::optional<BSpline> fit_spline(const std::vector<Vec2>& points, FitEnds ends) {
  constexpr double round_off = 1e-12;  // of the size: nearer points are the same
  Box box;
  for (const Vec2& point : points) box = expanded(box, point);
  std::vector<Vec2> kept;
  std::vector<double> parameters;
  const auto add = [&](const Vec2& point) {
    const double chord = kept.empty() ? 0 : (point - kept.back()).norm();
    if (!kept.empty() && !(chord > round_off * (box.upper - box.lower).norm())) return;
    parameters.push_back(kept.empty() ? 0 : parameters.back() + chord);
    kept.push_back(point);
  };
  for (const Vec2& point : points) add(point);
  if (ends.closed && !points.empty()) add(points.front());
  if (kept.size() < (ends.closed ? 4 : 2)) return std::nullopt;
  for (std::optional<Vec2>* direction : {&ends.start, &ends.end}) {
    if (*direction && (*direction)->norm() > 0)
      **direction /= (*direction)->norm();
    else
      direction->reset();
  }
  return cubic_through(kept, parameters, ends);
}

}  // namespace dda
