// When a wave arrives and how large it is, against the wave that should have come.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace dda {

// Relative errors; of speeds positive when the wave is too fast, measured over the time it should have taken.
struct ArrivalErrors {
  double speed = 0;        // by cross-correlation: the delay of the best least-squares fit
  double amplitude = 0;    // of the factor of that fit
  double peak = 0;         // of the first peak: the first extreme beyond half of the largest value of its sign, which
                           // is one that has a tenth of the largest of all
  double largest = 0;      // of the largest absolute value, among samples, of either sign and wherever it comes
  double peak_speed = 0;   // by the time of the first peak
  double onset_speed = 0;  // by the time at which a tenth of it is passed on the way to it
  double likeness = 0;     // normalised correlation at the delay, 1 for what has kept its shape
  double elsewhere = 0;    // the largest at delays that are not looked at: above likeness another part is more alike
  bool has_peak = true;    // false: what should come stays at its first peak for a while; nothing says when that is
  double lowest = 0;       // of what comes, in its own unit
  double highest = 0;
};

// Between which delays a wave comes, s: 0, and what the speeds of its parts say. Below 0 it is early.
struct Lags {
  double earliest = 0, latest = 0;

  void include(double lag) {
    earliest = std::min(earliest, lag);
    latest = std::max(latest, lag);
  }
};

// Whether `elsewhere` is asked for, which takes hundreds of comparisons more; it is 0 otherwise.
enum class OtherParts { ignored, compared };

// `trace` is sampled at 0, interval, ...; `exact` is what it should be, begins at `on_time` (s) and varies over times
// not much shorter than `period` (s). Nothing where the trace nowhere resembles it, or comes 0.45 periods before or
// after `lags`: beyond half a period a wave is mistaken for the next swing. Peaks of `exact` are its own and not
// those of its samples: a kink between two samples counts in full. The largest values are those up to `until` (s), or
// of all where the wave has hardly come by then.
std::optional<ArrivalErrors> read_arrival(const std::vector<double>& trace, double interval,
                                          const std::function<double(double)>& exact, double on_time, double period,
                                          const Lags& lags = {}, double until = std::numeric_limits<double>::infinity(),
                                          OtherParts others = OtherParts::ignored);

}  // namespace dda
