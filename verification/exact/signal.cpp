#include "verification/exact/signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace exact {
namespace {

double sign_of(Polarity polarity) { return static_cast<double>(static_cast<int>(polarity)); }

// Index of the first sample that is a local extremum of that sign beyond fraction of the largest one.
std::size_t first_peak_index(const Signal& signal, double sign, double fraction) {
  double largest = 0;
  for (const double value : signal.values) largest = std::max(largest, sign * value);
  for (std::size_t i = 1; largest > 0 && i + 1 < signal.values.size(); ++i) {
    const double value = sign * signal.values[i];
    const bool is_top = value >= sign * signal.values[i - 1] && value > sign * signal.values[i + 1];
    if (is_top && value >= fraction * largest) return i;
  }
  throw std::invalid_argument("the signal has no peak of the wanted sign");
}

double coefficient_at(const Signal& signal, const std::function<double(double)>& reference, double lag) {
  double product = 0, reference_energy = 0, signal_energy = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const double expected = reference(signal.time(i) - lag);
    product += signal.values[i] * expected;
    reference_energy += expected * expected;
    signal_energy += signal.values[i] * signal.values[i];
  }
  const double scale = std::sqrt(reference_energy * signal_energy);
  return scale > 0 ? product / scale : 0.0;
}

// Largest value within [low, high] of a function with one maximum there; the bracket shrinks to its round-off limit.
double golden_section(const std::function<double(double)>& value, double low, double high) {
  const double ratio = 1 / std::numbers::phi;
  double left = high - ratio * (high - low), right = low + ratio * (high - low);
  double at_left = value(left), at_right = value(right);
  for (int i = 0; i < 60; ++i) {
    if (at_left > at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      at_left = value(left = high - ratio * (high - low));
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      at_right = value(right = low + ratio * (high - low));
    }
  }
  return (low + high) / 2;
}

// The best of the lags first, first + pitch, ..., first + count pitch.
Correlation best_of_row(const std::function<double(double)>& value, double first, double pitch, int count) {
  Correlation best{first, value(first)};
  for (int i = 1; i <= count; ++i) {
    const double lag = first + i * pitch, coefficient = value(lag);
    if (coefficient > best.coefficient) best = {lag, coefficient};
  }
  return best;
}

}  // namespace

Signal window(const Signal& signal, double t_a, double t_b) {
  const double slack = 1e-6;  // of an interval: times are products and may miss the end by round-off
  const double first = std::max(0.0, std::ceil((t_a - signal.start) / signal.interval - slack));
  const double last = std::min(static_cast<double>(signal.values.size()) - 1,
                               std::floor((t_b - signal.start) / signal.interval + slack));
  if (!(first <= last)) throw std::invalid_argument("the window holds no sample of the signal");
  const auto begin = static_cast<std::size_t>(first), count = static_cast<std::size_t>(last - first) + 1;
  return {signal.values.subspan(begin, count), signal.interval, signal.time(begin)};
}

double half_range(const Signal& signal, double t_a, double t_b) {
  const auto [low, high] = std::ranges::minmax(window(signal, t_a, t_b).values);
  return (high - low) / 2;
}

Peak first_peak(const Signal& signal, Polarity polarity, double fraction) {
  const std::size_t top = first_peak_index(signal, sign_of(polarity), fraction);
  const double before = signal.values[top - 1], at = signal.values[top], after = signal.values[top + 1];
  const double slope = (after - before) / 2, curvature = before - 2 * at + after;
  const double shift = -slope / curvature;  // in intervals, within [-1/2, 1/2]
  return {signal.time(top) + shift * signal.interval, at + slope * shift / 2};
}

double onset(const Signal& signal, Polarity polarity, double fraction) {
  const double sign = sign_of(polarity);
  for (std::size_t i = first_peak_index(signal, sign, fraction); i-- > 0;) {
    const double before = sign * signal.values[i], after = sign * signal.values[i + 1];
    if (before <= 0) return signal.time(i) + signal.interval * before / (before - after);
  }
  throw std::invalid_argument("the signal has the sign of its peak from the first sample on");
}

double interpolate(const Signal& signal, double t) {
  const double position = (t - signal.start) / signal.interval;
  const double last = static_cast<double>(signal.values.size()) - 1;
  if (last < 5) throw std::invalid_argument("interpolation needs at least six samples");
  if (!(position >= 0 && position <= last)) return 0;
  const double first = std::clamp(std::floor(position) - 2, 0.0, last - 5);
  double sum = 0;
  for (int i = 0; i < 6; ++i) {
    double weight = 1;
    for (int j = 0; j < 6; ++j) {
      if (j != i) weight *= (position - first - j) / (i - j);
    }
    sum += weight * signal.values[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)];
  }
  return sum;
}

Correlation correlation_lag(const Signal& signal, const std::function<double(double)>& reference, double lag_min,
                            double lag_max) {
  const auto value = [&](double lag) { return coefficient_at(signal, reference, lag); };
  // A lag per interval resolves whatever the samples resolve. Where the reference has kinks and samples are few, so has
  // the coefficient, with summits within an interval; hence a finer row around the best of them.
  const int count = std::max(2, static_cast<int>(std::ceil((lag_max - lag_min) / signal.interval)));
  const double pitch = (lag_max - lag_min) / count;
  const Correlation coarse = best_of_row(value, lag_min, pitch, count);
  if (!(coarse.coefficient > 0)) throw std::invalid_argument("the signal nowhere correlates with the reference");
  constexpr int finer = 32;
  const double first = std::max(lag_min, coarse.lag - pitch);
  const double fine = (std::min(lag_max, coarse.lag + pitch) - first) / finer;
  const Correlation best = best_of_row(value, first, fine, finer);
  const double low = std::max(lag_min, best.lag - fine), high = std::min(lag_max, best.lag + fine);
  const double lag = golden_section(value, low, high);
  return {lag, value(lag)};
}

Correlation correlation_lag(const Signal& signal, const Signal& reference, double lag_min, double lag_max) {
  return correlation_lag(
      signal, [&](double t) { return interpolate(reference, t); }, lag_min, lag_max);
}

}  // namespace exact
