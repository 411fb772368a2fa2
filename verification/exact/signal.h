// Measurements on a history sampled at equal intervals: amplitude, first peak, onset, arrival by cross-correlation.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace exact {

// A view of a history: values[i] is taken at start + i interval (s). The values must outlive it.
struct Signal {
  std::span<const double> values;
  double interval = 1.0;
  double start = 0.0;

  [[nodiscard]] double time(std::size_t i) const { return start + static_cast<double>(i) * interval; }
};

// The samples with t_a <= t <= t_b (ends included to round-off). Throws std::invalid_argument if there are none.
[[nodiscard]] Signal window(const Signal& signal, double t_a, double t_b);

// (largest - smallest sample)/2 within [t_a, t_b]: the amplitude of thesis Table 3.2 (its window ends before the
// reflection arrives).
[[nodiscard]] double half_range(const Signal& signal, double t_a, double t_b);

enum class Polarity { positive = 1, negative = -1 };

struct Peak {
  double time = 0;   // s
  double value = 0;  // signed, unit of the signal
};

// First local extremum of that polarity beyond `fraction` of the largest value of that polarity, refined by the
// parabola through three samples (error: third order in the interval). Throws std::invalid_argument if there is none.
[[nodiscard]] Peak first_peak(const Signal& signal, Polarity polarity, double fraction = 0.5);

// Time of the last change of sign before the first peak (linear between samples). Travelled distance/onset is the
// velocity pick of thesis Table 3.3, with Polarity::negative for a compressive load and sigma_x tension positive.
[[nodiscard]] double onset(const Signal& signal, Polarity polarity, double fraction = 0.5);

struct Correlation {
  double lag = 0;          // s; the signal is the reference delayed by this
  double coefficient = 0;  // -, normalised to [-1, 1]
};

// Delay in [lag_min, lag_max] that maximises the normalised cross-correlation of the samples with reference(t - lag),
// found between the samples by golden-section search. It is the delay of the best least-squares fit of a scaled
// reference. Throws std::invalid_argument if the reference vanishes over the samples for every lag.
[[nodiscard]] Correlation correlation_lag(const Signal& signal, const std::function<double(double)>& reference,
                                          double lag_min, double lag_max);

// The same against a sampled reference, interpolated with six points (fifth degree); it is 0 outside its samples.
[[nodiscard]] Correlation correlation_lag(const Signal& signal, const Signal& reference, double lag_min,
                                          double lag_max);

// Fifth-degree Lagrange interpolation of the samples at time t (needs at least six samples); 0 outside of them.
[[nodiscard]] double interpolate(const Signal& signal, double t);

}  // namespace exact
