// Dimensionless histories of loads and prescribed motions: value = amplitude * f(t), t in s from the start of the
// scene.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "engine/model/recording.h"

namespace dda {

struct Constant {};

// Straight lines through (times, values), times strictly increasing; the end values hold outside the table.
struct PiecewiseLinear {
  std::vector<double> times;  // s
  std::vector<double> values;
};

// sin(2 pi frequency (t - start)) for `cycles` periods from `start`, zero before and after. Infinite cycles: no end.
struct SineCycles {
  double frequency = 0;  // Hz
  double cycles = 1;
  double start = 0;  // s
};

// Zero before `start`, a straight line to 1 over `rise` (a jump when that is 0), then exp(-t'/decay_time), t' counted
// from there (thesis Eq. 18 with start = 1.1 ta, decay_time = ta).
struct ExponentialDecay {
  double decay_time = 0;  // s
  double start = 0;       // s
  double rise = 0;        // s
};

// A recording whose clock shows zero at `start`. Copies share the samples.
struct Recorded {
  std::shared_ptr<const Recording> recording;
  double start = 0;  // s
};

using TimeFunction = std::variant<Constant, PiecewiseLinear, SineCycles, ExponentialDecay, Recorded>;

double evaluate(const TimeFunction& history, double time);

}  // namespace dda
