#include "engine/cutting/pixel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dda {
namespace {

constexpr int steps_in_extent_exponent = 40;

int sign(Wide value) { return (value > 0) - (value < 0); }

// numerator / denominator to the nearest whole number; halves go up, as the pixel does not include its upper sides.
std::int64_t rounded_quotient(Wide numerator, Wide denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const Wide twice = 2 * numerator + denominator;
  const Wide quotient = twice / (2 * denominator);
  return static_cast<std::int64_t>(twice % (2 * denominator) < 0 ? quotient - 1 : quotient);
}

bool between(std::int64_t value, std::int64_t a, std::int64_t b) {
  return std::min(a, b) <= value && value <= std::max(a, b);
}

bool boxes_meet(const PixelSegment& a, const PixelSegment& b) {
  const auto [a_left, a_right] = std::minmax(a.from.x, a.to.x);
  const auto [b_left, b_right] = std::minmax(b.from.x, b.to.x);
  const auto [a_low, a_high] = std::minmax(a.from.y, a.to.y);
  const auto [b_low, b_high] = std::minmax(b.from.y, b.to.y);
  return a_left <= b_right && b_left <= a_right && a_low <= b_high && b_low <= a_high;
}

bool in_upper_half(const Pixel& direction) { return direction.y > 0 || (direction.y == 0 && direction.x > 0); }

}  // namespace

PixelGrid::PixelGrid(const Box& box)
    : origin_((box.lower + box.upper) / 2),
      step_(std::exp2(std::ceil(std::log2((box.upper - box.lower).maxCoeff())) - steps_in_extent_exponent)) {}

Pixel PixelGrid::pixel_of(const Vec2& point) const {
  const Vec2 steps = (point - origin_) / step_;
  return {static_cast<std::int64_t>(std::floor(steps.x() + 0.5)),
          static_cast<std::int64_t>(std::floor(steps.y() + 0.5))};
}

Vec2 PixelGrid::centre_of(const Pixel& pixel) const {
  return origin_ + step_ * Vec2(static_cast<double>(pixel.x), static_cast<double>(pixel.y));
}

std::optional<Pixel> crossing(const PixelSegment& a, const PixelSegment& b) {
  if (!boxes_meet(a, b)) return std::nullopt;
  const Wide from_side = turn(a.from, a.to, b.from);
  const Wide to_side = turn(a.from, a.to, b.to);
  if (sign(from_side) * sign(to_side) >= 0) return std::nullopt;
  if (sign(turn(b.from, b.to, a.from)) * sign(turn(b.from, b.to, a.to)) >= 0) return std::nullopt;
  const Pixel along = b.to - b.from;
  const Wide whole = from_side - to_side;
  return Pixel{b.from.x + rounded_quotient(from_side * along.x, whole),
               b.from.y + rounded_quotient(from_side * along.y, whole)};
}

// Separating axes: x, y and the normal of the segment. The half-open square is that of a segment moved by (e, e^2) with
// e > 0 as small as need be, which decides the case of equality.
bool enters(const PixelSegment& segment, const Pixel& pixel) {
  if (!between(pixel.x, segment.from.x, segment.to.x) || !between(pixel.y, segment.from.y, segment.to.y)) return false;
  const Pixel along = segment.to - segment.from;
  const Wide offset = 2 * cross(along, pixel - segment.from);
  const Wide reach = Wide(std::abs(along.x)) + std::abs(along.y);
  const Wide distance = offset < 0 ? -offset : offset;
  if (distance != reach) return distance < reach;
  if (reach == 0) return true;
  const bool nearer_when_positive = along.y < 0 || (along.y == 0 && along.x > 0);
  return (offset > 0) == nearer_when_positive;
}

bool before_in_angle(const Pixel& a, const Pixel& b) {
  if (in_upper_half(a) != in_upper_half(b)) return in_upper_half(a);
  return cross(a, b) > 0;
}

}  // namespace dda
