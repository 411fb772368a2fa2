#include "engine/advice/arrival.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace dda {
namespace {

constexpr double longest_lag = 0.45;  // of a period
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double onset_share = 0.1;  // of the largest value
constexpr double flat = 0.1;         // of a period: what stays so long at its peak has none to read a time off
constexpr double other_sign_share = 0.1;

struct Fit {
  double factor = 0;
  double coefficient = 0;  // normalised correlation
  double wanted = 0;       // sum of squares of what should come
};

// Where a function with one summit between `low` and `high` has it, by golden sections.
template <typename Value>
double place_of_largest(const Value& value, double low, double high) {
  constexpr double ratio = 0.6180339887498949;
  double left = high - ratio * (high - low), right = low + ratio * (high - low);
  double at_left = value(left), at_right = value(right);
  for (int i = 0; i < 30; ++i) {
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
    return {both / wanted, both / std::sqrt(wanted * found), wanted};
  }

  // The largest coefficient at delays from `first` on that leave at least half of what should come in the trace, but
  // for those from `low` to `high`.
  [[nodiscard]] double best_outside(double first, double low, double high, double pitch) const {
    double most = 0;
    const double whole = fit(0).wanted;
    const double last = static_cast<double>(trace_.size()) * interval_;
    for (double lag = first; lag < last; lag += pitch) {
      if (lag >= low && lag <= high) continue;
      const Fit fit = this->fit(lag);
      if (fit.wanted >= whole / 2) most = std::max(most, fit.coefficient);
    }
    return most;
  }

  // The delay with the largest coefficient from `low` to `high`. Where a load has kinks and its samples are few, so has
  // the coefficient, with summits side by side; so a row of delays is looked at, a finer row around the best of them,
  // and what lies between the neighbours of the best of those.
  [[nodiscard]] double best_lag(double low, double high, double pitch) const {
    constexpr int fine = 16;
    const double near = best_of_row(0, pitch, static_cast<int>(std::ceil(low / pitch - 1e-9)),
                                    static_cast<int>(std::floor(high / pitch + 1e-9)));
    const double nearer = best_of_row(near, pitch / fine, -fine, fine);
    return place_of_largest([&](double lag) { return fit(lag).coefficient; }, std::max(nearer - pitch / fine, low),
                            std::min(nearer + pitch / fine, high));
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

// Reads the marks off samples: the peak is refined between them by a parabola, the onset by a straight line.
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

// Reads peaks off a history that is known at all times. A row of samples says near which of them a summit is.
class Exact {
 public:
  Exact(const std::function<double(double)>& value, double interval, std::size_t samples)
      : value_(value), pitch_(interval / finer) {
    row_.resize((samples - 1) * finer + 1);
    for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = value(static_cast<double>(i) * pitch_);
  }

  // The peak that samples have at that time, or a kink beside it that they pass over.
  [[nodiscard]] double peak_near(const Marks& marks) const {
    const double up = marks.peak > 0 ? 1 : -1;
    const double middle = std::round(marks.peak_time / pitch_);
    const auto first = static_cast<std::size_t>(std::max(0.0, middle - finer));
    const std::size_t last = std::min(static_cast<std::size_t>(std::max(0.0, middle)) + finer, row_.size() - 1);
    std::size_t top = first;
    for (std::size_t i = first; i <= last; ++i)
      if (up * row_[i] > up * row_[top]) top = i;
    return up * std::max(up * row_[top], up * value_(summit_near(top)));
  }

  // Whether it stays at that peak to the end, or for `least` (s): no sample of it then says when the peak is.
  [[nodiscard]] bool stays_at(const Marks& marks, double least) const {
    constexpr double much = 0.01;
    const auto is_there = [&](double value) { return std::abs(value - marks.peak) <= much * std::abs(marks.peak); };
    const auto place = static_cast<std::ptrdiff_t>(
        std::min(std::max(0.0, std::round(marks.peak_time / pitch_)), static_cast<double>(row_.size() - 1)));
    const auto top = row_.begin() + place;
    const auto after = std::find_if_not(top, row_.end(), is_there);
    const auto before = std::find_if_not(std::make_reverse_iterator(top), row_.rend(), is_there);
    return after == row_.end() || static_cast<double>(after - before.base()) * pitch_ > least;
  }

  [[nodiscard]] double largest(double until) const {
    std::size_t top = 0;
    for (std::size_t i = 0; i < row_.size() && static_cast<double>(i) * pitch_ <= until; ++i)
      if (std::abs(row_[i]) > std::abs(row_[top])) top = i;
    return std::max(std::abs(row_[top]), std::abs(value_(std::min(summit_near(top), until))));
  }

 private:
  static constexpr std::size_t finer = 8;

  [[nodiscard]] double summit_near(std::size_t top) const {
    const double at = static_cast<double>(top) * pitch_;
    const double last = static_cast<double>(row_.size() - 1) * pitch_;
    return place_of_largest([&](double t) { return row_[top] > 0 ? value_(t) : -value_(t); },
                            std::max(at - pitch_, 0.0), std::min(at + pitch_, last));
  }

  const std::function<double(double)>& value_;
  double pitch_;  // s
  std::vector<double> row_;
};

double largest_of(const std::vector<double>& values, double interval, double until) {
  double largest = 0;
  for (std::size_t i = 0; i < values.size() && static_cast<double>(i) * interval <= until; ++i)
    largest = std::max(largest, std::abs(values[i]));
  return largest;
}

double speed_error(double on_time, double lag) { return on_time / (on_time + lag) - 1; }

}  // namespace

std::optional<ArrivalErrors> read_arrival(const std::vector<double>& trace, double interval,
                                          const std::function<double(double)>& exact, double on_time, double period,
                                          const Lags& lags, double until, OtherParts others) {
  constexpr double pitch = longest_lag / 40;  // of a period
  const Comparison comparison(trace, interval, exact);
  const double limit = longest_lag * period;
  const double lag = comparison.best_lag(lags.earliest - limit, lags.latest + limit, pitch * period);
  const Fit fit = comparison.fit(lag);
  const bool at_end = lag < lags.earliest - 0.99 * limit || lag > lags.latest + 0.99 * limit;
  if (!(fit.coefficient > 0) || at_end || on_time + lag <= 0) return std::nullopt;
  // Times are read alike from what should come and what comes, so that what samples do to them is in both.
  std::vector<double> samples(trace.size());
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = exact(static_cast<double>(i) * interval);
  const Marks due = marks_of(samples, interval, 0);
  const Exact wanted(exact, interval, trace.size());
  const Marks found = marks_of(trace, interval, due.peak);
  ArrivalErrors errors;
  errors.speed = speed_error(on_time, lag);
  errors.amplitude = fit.factor - 1;
  errors.likeness = fit.coefficient;
  if (others == OtherParts::compared)
    errors.elsewhere = comparison.best_outside(-0.9 * on_time, lags.earliest - limit, lags.latest + limit, period / 20);
  errors.has_peak = !wanted.stays_at(due, flat * period);
  const auto [lowest, highest] = std::minmax_element(trace.begin(), trace.end());
  errors.lowest = *lowest;
  errors.highest = *highest;
  errors.peak = found.peak / wanted.peak_near(due) - 1;
  const bool has_come = wanted.largest(until) >= 0.5 * wanted.largest(never);
  double looked_at = never;
  if (has_come) looked_at = until;
  errors.largest = largest_of(trace, interval, looked_at) / wanted.largest(looked_at) - 1;
  errors.peak_speed = speed_error(on_time, found.peak_time - due.peak_time);
  errors.onset_speed = speed_error(on_time, found.onset_time - due.onset_time);
  return errors;
}

}  // namespace dda
