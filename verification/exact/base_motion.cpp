#include "verification/exact/base_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace exact {
namespace {

// Calls `advance(value, slope, length)` for each interval up to `time`; after the last sample the base is free of
// acceleration.
template <typename Advance>
void for_each_interval(const Accelerogram& record, double time, const Advance& advance) {
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    const double start = record.times[i - 1];
    if (time <= start) return;
    const double slope = (record.values[i] - record.values[i - 1]) / (record.times[i] - start);
    advance(record.values[i - 1], slope, std::min(time, record.times[i]) - start);
  }
  if (time > record.times.back()) advance(0, 0, time - record.times.back());
}

}  // namespace

BaseMotion base_motion(const Accelerogram& record, double time) {
  BaseMotion motion;
  for_each_interval(record, time, [&motion](double value, double slope, double t) {
    motion.displacement += motion.velocity * t + value * t * t / 2 + slope * t * t * t / 6;
    motion.velocity += value * t + slope * t * t / 2;
  });
  return motion;
}

BaseMotion oscillator_on_base(const Accelerogram& record, double omega, double time) {
  BaseMotion motion;
  for_each_interval(record, time, [&motion, omega](double value, double slope, double t) {
    const double square = omega * omega;
    const double free = motion.displacement + value / square;
    const double free_rate = motion.velocity + slope / square;
    const double c = std::cos(omega * t);
    const double s = std::sin(omega * t);
    motion.displacement = free * c + free_rate / omega * s - (value + slope * t) / square;
    motion.velocity = -free * omega * s + free_rate * c - slope / square;
  });
  return motion;
}

}  // namespace exact
