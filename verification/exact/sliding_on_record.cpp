#include "verification/exact/sliding_on_record.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace exact {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// value + slope t
struct Line {
  double value = 0, slope = 0;

  [[nodiscard]] double at(double t) const { return value + slope * t; }
  [[nodiscard]] Line after(double t) const { return {at(t), slope}; }
};

Line sum(const Line& a, double factor, const Line& b) {
  return {a.value + factor * b.value, a.slope + factor * b.slope};
}

// m/s2: a slip ends with a drive that is the limit but for this.
constexpr double round_off = 1e-12;

// When a line that is not above zero, or just there, rises above it.
double rises_above_zero(const Line& line) {
  if (line.slope <= 0) return line.value > round_off ? 0 : never;
  return std::max(0.0, -line.value / line.slope);
}

// First t > 0 at which speed + a t + b t^2/2 is zero, for a speed that is positive, or zero and about to be so.
double stops(double speed, const Line& acceleration) {
  const double a = acceleration.value;
  const double b = acceleration.slope;
  const double root = a * a - 2 * b * speed;
  if (root < 0) return never;
  // The smaller positive root of the two -2 v/(a +- sqrt(root)); from rest, the other one is zero.
  const double by_minus = a - std::sqrt(root);
  if (speed > 0) return by_minus < 0 ? -2 * speed / by_minus : never;
  return b < 0 ? -2 * a / b : never;
}

// A block within one interval of the record.
class Slider {
 public:
  Slider(BaseMotion& motion, const Line& drive, const Line& limit, double length)
      : motion_(motion), drive_(drive), limit_(limit), left_(length) {}

  void go_on() {
    while (left_ > 0) motion_.velocity == 0 ? stay() : slide(motion_.velocity > 0 ? 1 : -1);
  }

 private:
  void stay() {
    const double down = rises_above_zero(sum(drive_, -1, limit_));
    const double up = rises_above_zero(sum({-drive_.value, -drive_.slope}, -1, limit_));
    const double rest = std::min({down, up, left_});
    pass(rest);
    if (left_ > 0) slide(down < up ? 1 : -1);
  }

  void slide(double side) {
    const Line acceleration = sum(drive_, -side, limit_);
    const double end = stops(std::abs(motion_.velocity), {side * acceleration.value, side * acceleration.slope});
    const double t = std::min(end, left_);
    motion_.displacement += t * (motion_.velocity + t * (acceleration.value / 2 + t * acceleration.slope / 6));
    motion_.velocity = end <= left_ ? 0 : motion_.velocity + t * (acceleration.value + t * acceleration.slope / 2);
    pass(t);
  }

  void pass(double t) {
    left_ = t < left_ ? left_ - t : 0;
    drive_ = drive_.after(t);
    limit_ = limit_.after(t);
  }

  BaseMotion& motion_;
  Line drive_, limit_;
  double left_;
};

}  // namespace

BaseMotion slide_on_record(const SlidingPlane& plane, const Accelerogram& record, double time) {
  const double s = std::sin(plane.slope);
  const double c = std::cos(plane.slope);
  BaseMotion motion;
  const auto pass_interval = [&](const Line& felt, double length) {
    const Line drive{plane.gravity * s + c * felt.value, c * felt.slope};
    const Line limit{plane.friction * (plane.gravity * c - s * felt.value), -plane.friction * s * felt.slope};
    Slider(motion, drive, limit, length).go_on();
  };
  for (std::size_t i = 1; i < record.times.size() && record.times[i - 1] < time; ++i) {
    const double start = record.times[i - 1];
    const double slope = (record.values[i] - record.values[i - 1]) / (record.times[i] - start);
    pass_interval({record.values[i - 1], slope}, std::min(time, record.times[i]) - start);
  }
  if (time > record.times.back()) pass_interval({0, 0}, time - record.times.back());
  return motion;
}

}  // namespace exact
