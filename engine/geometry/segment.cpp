#include "engine/geometry/segment.h"

namespace dda {
namespace {

bool opposite(double p, double q) { return (p < 0 && q > 0) || (p > 0 && q < 0); }

}  // namespace

std::optional<Vec2> proper_intersection(const Segment& a, const Segment& b) {
  const Vec2 along_a = a.end - a.start;
  const Vec2 along_b = b.end - b.start;
  const double start_side = cross(along_b, a.start - b.start);  // of a's ends as seen from b
  const double end_side = cross(along_b, a.end - b.start);
  if (!opposite(start_side, end_side)) return std::nullopt;
  if (!opposite(cross(along_a, b.start - a.start), cross(along_a, b.end - a.start))) return std::nullopt;
  return point_at(a, start_side / (start_side - end_side));
}

double distance(const Segment& a, const Segment& b) {
  if (proper_intersection(a, b)) return 0;
  return std::min({distance(a, b.start), distance(a, b.end), distance(b, a.start), distance(b, a.end)});
}

std::optional<std::pair<Vec2, Vec2>> collinear_overlap(const Segment& a, const Segment& b, double tolerance) {
  const double length = (a.end - a.start).norm();
  if (length <= tolerance) return std::nullopt;
  const Vec2 direction = (a.end - a.start) / length;
  const double b_start = direction.dot(b.start - a.start);  // arc length along a of b's ends
  const double b_end = direction.dot(b.end - a.start);
  const double first = std::max(0.0, std::min(b_start, b_end));
  const double last = std::min(length, std::max(b_start, b_end));
  if (last - first <= tolerance) return std::nullopt;
  const auto gap = [&](double at) {
    return std::abs(cross(direction, point_at(b, (at - b_start) / (b_end - b_start)) - a.start));
  };
  if (gap(first) > tolerance || gap(last) > tolerance) return std::nullopt;
  return std::pair(Vec2(a.start + first * direction), Vec2(a.start + last * direction));
}

}  // namespace dda
