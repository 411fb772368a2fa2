#include "engine/model/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/core/error.h"

namespace dda {
namespace {

void check(const std::vector<double>& times, const std::vector<double>& values) {
  if (times.size() != values.size() || times.size() < 2)
    throw InputError("", "recording", fmt::format("{} times and {} values", times.size(), values.size()),
                     "as many values as times, at least two");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !std::isfinite(values[i]))
      throw InputError("", fmt::format("recording sample {}", i), fmt::format("({}, {})", times[i], values[i]),
                       "finite numbers");
    if (i > 0 && times[i] <= times[i - 1])
      throw InputError("", fmt::format("recording time {}", i), fmt::format("{} after {}", times[i], times[i - 1]),
                       "increasing times");
  }
}

// Between numbers near the ends of what a double holds.
void check_derived(const std::vector<double>& times, const std::vector<double>& values, std::size_t i,
                   double integral) {
  const double slope = (values[i] - values[i - 1]) / (times[i] - times[i - 1]);
  if (std::isfinite(slope) && std::isfinite(integral)) return;
  throw InputError("", fmt::format("recording sample {}", i), fmt::format("({}, {})", times[i], values[i]),
                   "a sample with which slopes and integrals are finite numbers");
}

}  // namespace

Recording::Recording(std::string name, std::vector<double> times, std::vector<double> values)
    : name_(std::move(name)), times_(std::move(times)), values_(std::move(values)) {
  check(times_, values_);
  integrals_.assign(times_.size(), 0);
  second_integrals_.assign(times_.size(), 0);
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double h = times_[i] - times_[i - 1];
    integrals_[i] = integrals_[i - 1] + h * (values_[i - 1] + values_[i]) / 2;
    second_integrals_[i] =
        second_integrals_[i - 1] + h * integrals_[i - 1] + h * h * (2 * values_[i - 1] + values_[i]) / 6;
    check_derived(times_, values_, i, integrals_[i] + second_integrals_[i]);
  }
}

double Recording::peak() const {
  double largest = 0;
  for (const double value : values_) largest = std::max(largest, std::abs(value));
  return largest;
}

std::size_t Recording::sample_before(double time) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), time);
  return static_cast<std::size_t>(next - times_.begin()) - 1;
}

double Recording::slope_after(std::size_t sample) const {
  return (values_[sample + 1] - values_[sample]) / (times_[sample + 1] - times_[sample]);
}

double Recording::value(double time) const {
  if (time < times_.front() || time > times_.back()) return 0;
  if (time == times_.back()) return values_.back();
  const std::size_t i = sample_before(time);
  return values_[i] + slope_after(i) * (time - times_[i]);
}

double Recording::slope(double time) const {
  if (time < times_.front() || time >= times_.back()) return 0;
  return slope_after(sample_before(time));
}

double Recording::integral(double time) const {
  if (time <= times_.front()) return 0;
  if (time >= times_.back()) return integrals_.back();
  const std::size_t i = sample_before(time);
  const double t = time - times_[i];
  return integrals_[i] + t * (values_[i] + slope_after(i) * t / 2);
}

double Recording::second_integral(double time) const {
  if (time <= times_.front()) return 0;
  if (time >= times_.back()) return second_integrals_.back() + integrals_.back() * (time - times_.back());
  const std::size_t i = sample_before(time);
  const double t = time - times_[i];
  return second_integrals_[i] + t * (integrals_[i] + t * (values_[i] / 2 + slope_after(i) * t / 6));
}

// With s = (t - first)/duration T, the line c0 + c1 s has the integrals T (c0 + c1/2) and T^2 (c0/2 + c1/6).
Recording Recording::corrected() const {
  const double mean = integrals_.back() / duration();
  const double lever = second_integrals_.back() / (duration() * duration());
  const double at_start = 6 * lever - 2 * mean;
  const double rise = 6 * mean - 12 * lever;
  std::vector<double> values = values_;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= at_start + rise * (times_[i] - times_.front()) / duration();
  return {name_, times_, std::move(values)};
}

}  // namespace dda
