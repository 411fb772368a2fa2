#include "engine/advice/limits.h"

#include <cmath>

namespace dda {
namespace {

constexpr double pitch = 2;
constexpr int pitches = 10;  // down to a thousandth of the coarsest
constexpr int bisections = 4;

// The largest value up to `coarsest` that is within, as find_limits says.
std::optional<double> largest_within(const std::function<bool(double)>& within, double coarsest) {
  double value = coarsest;
  for (int i = 0; i <= pitches; ++i, value /= pitch) {
    if (!within(value) || !within(0.8 * value)) continue;
    if (i == 0) return value;
    double low = value, high = pitch * value;
    for (int j = 0; j < bisections; ++j) {
      const double middle = std::sqrt(low * high);
      (within(middle) ? low : high) = middle;
    }
    return low;
  }
  return std::nullopt;
}

}  // namespace

WaveLimits find_limits(const ErrorOf& error_of, double dt, const CoarseBounds& coarse, double wanted) {
  const auto within = [&](double step, double scale, double bound) {
    const auto error = error_of(step, scale);
    return error && *error <= bound;
  };
  WaveLimits limits;
  const double least = std::pow(pitch, -pitches);
  limits.coarsest = coarse;
  limits.finest = {coarse.dt * least, coarse.scale * least};
  limits.dt = largest_within([&](double step) { return within(step, 1, wanted); }, coarse.dt);
  limits.scale = largest_within([&](double scale) { return within(dt, scale, wanted); }, coarse.scale);
  if (limits.dt || limits.scale) return limits;
  // Half of the error for the blocks at a dt that adds next to nothing, the rest for dt.
  limits.both_scale =
      largest_within([&](double scale) { return within(limits.finest.dt, scale, wanted / 2); }, coarse.scale);
  if (!limits.both_scale) return limits;
  limits.both_dt = largest_within([&](double step) { return within(step, *limits.both_scale, wanted); }, coarse.dt);
  if (!limits.both_dt) limits.both_scale.reset();
  return limits;
}

}  // namespace dda
