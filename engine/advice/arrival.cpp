#include "engine/advice/arrival.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

constexpr double longest_lag = 0.45;  // of a period
constexpr double onset_share = 0.1;   // of the largest value
constexpr double other_sign_share = 0.1;

struct Fit {
  double factor = 0;
  double coefficient = 0;  // normalised correlation
};

class Comparison {
 public:
  Comparison(const std::vector<double>& trace, double interval, const std::function<double(double)>& exact)
      : trace_(trace), interval_(interval), exact_(exact) {}

  [[nodiscard]] Fit fit(double lag) const {
    double both = 0, wanted = 0, found = 0;
    for (std::size_t i = 0; i < trace_.size(); ++i) {
      const double expected = exact_(static_cast<double>(i) * interval_ - lag);
      both += trace_[i] * expected;
      wanted += expected * expected;
      found += trace_[i] * trace_[i];
    }
    if (!(wanted > 0) || !(found > 0)) return {};
    return {both / wanted, both / std::sqrt(wanted * found)};
  }

  // The delay with the largest coefficient from `low` to `high`. Where a load has kinks and its samples are few, so has
  // the coefficient, with summits side by side; so a row of delays is looked at, a finer row around the best of them,
  // and what lies between the neighbours of the best of those.
  [[nodiscard]] double best_lag(double low, double high, double pitch) const {
    constexpr int fine = 16;
    const double near = best_of_row(0, pitch, static_cast<int>(std::ceil(low / pitch - 1e-9)),
                                    static_cast<int>(std::floor(high / pitch + 1e-9)));
    const double nearer = best_of_row(near, pitch / fine, -fine, fine);
    return largest_between(std::max(nearer - pitch / fine, low), std::min(nearer + pitch / fine, high));
  }

 private:
  [[nodiscard]] double best_of_row(double middle, double pitch, int first, int last) const {
    double best = middle, most = -1;
    for (int i = first; i <= last; ++i) {
      const double coefficient = fit(middle + i * pitch).coefficient;
      if (coefficient <= most) continue;
      most = coefficient;
      best = middle + i * pitch;
    }
    return best;
  }

  [[nodiscard]] double largest_between(double low, double high) const {
    constexpr double ratio = 0.6180339887498949;
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double at_left = fit(left).coefficient, at_right = fit(right).coefficient;
    for (int i = 0; i < 30; ++i) {
      if (at_left > at_right) {
        high = std::exchange(right, left);
        at_right = at_left;
        at_left = fit(left = high - ratio * (high - low)).coefficient;
      } else {
        low = std::exchange(left, right);
        at_left = at_right;
        at_right = fit(right = low + ratio * (high - low)).coefficient;
      }
    }
    return (low + high) / 2;
  }

  const std::vector<double>& trace_;
  double interval_;
  const std::function<double(double)>& exact_;
};

struct Marks {
  double peak = 0, peak_time = 0, onset_time = 0;
};

// The first local extreme beyond half of the largest value of its sign, which is `sign`, or that of whichever sign
// comes first when it is 0. A sign of which there is less than a tenth of the other is none that a peak has: a wave of
// one sign has round-off of the other.
std::size_t first_peak(const std::vector<double>& values, double sign) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double least = sign == 0 ? other_sign_share * std::max(-*low, *high) : 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    const double before = i > 0 ? values[i - 1] : 0, after = i + 1 < values.size() ? values[i + 1] : 0;
    if (sign * value < 0 || value == 0) continue;
    const double up = value > 0 ? 1 : -1;
    const double largest = std::abs(value > 0 ? *high : *low);
    const bool is_top = up * value >= up * before && up * value > up * after;
    if (is_top && largest >= least && std::abs(value) >= 0.5 * largest) return i;
  }
  return 0;
}

// Refined between the samples by a parabola and a straight line.
Marks marks_of(const std::vector<double>& values, double interval, double sign) {
  const std::size_t top = first_peak(values, sign);
  Marks marks{values[top], static_cast<double>(top) * interval, 0};
  if (top > 0 && top + 1 < values.size()) {
    const double slope = (values[top + 1] - values[top - 1]) / 2;
    const double curvature = values[top - 1] - 2 * values[top] + values[top + 1];
    const double shift = curvature != 0 ? -slope / curvature : 0;
    marks.peak_time += shift * interval;
    marks.peak += slope * shift / 2;
  }
  // A tenth of the peak is passed for the last time before it.
  const double level = onset_share * marks.peak;
  std::size_t i = top;
  while (i > 0 && values[i - 1] / level > 1) --i;
  const double last = i > 0 ? values[i - 1] : 0;
  marks.onset_time = (static_cast<double>(i) - (values[i] - level) / (values[i] - last)) * interval;
  return marks;
}

double speed_error(double on_time, double lag) { return on_time / (on_time + lag) - 1; }

}  // namespace

std::optional<ArrivalErrors> read_arrival(const std::vector<double>& trace, double interval,
                                          const std::function<double(double)>& exact, double on_time, double period,
                                          const Lags& lags) {
  constexpr double pitch = longest_lag / 40;  // of a period
  const Comparison comparison(trace, interval, exact);
  const double limit = longest_lag * period;
  const double lag = comparison.best_lag(lags.earliest - limit, lags.latest + limit, pitch * period);
  const Fit fit = comparison.fit(lag);
  const bool at_end = lag < lags.earliest - 0.99 * limit || lag > lags.latest + 0.99 * limit;
  if (!(fit.coefficient > 0) || at_end || on_time + lag <= 0) return std::nullopt;
  std::vector<double> wanted(trace.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = exact(static_cast<double>(i) * interval);
  const Marks due = marks_of(wanted, interval, 0);
  const Marks found = marks_of(trace, interval, due.peak);
  ArrivalErrors errors;
  errors.speed = speed_error(on_time, lag);
  errors.amplitude = fit.factor - 1;
  errors.peak = found.peak / due.peak - 1;
  errors.peak_speed = speed_error(on_time, found.peak_time - due.peak_time);
  errors.onset_speed = speed_error(on_time, found.onset_time - due.onset_time);
  return errors;
}

}  // namespace dda
