#include "verification/thesis/wave_picks.h"

#include <cmath>

#include "verification/exact/bar_stress.h"
#include "verification/exact/signal.h"

namespace verify {

double reflection_time(const ThesisBar& bar) { return (2 * bar.length - bar.measuring_point) / bar.wave_speed(); }

double window_end(const ThesisBar& bar) {
  const double passed = bar.measuring_point / bar.wave_speed() + 1 / bar.load_frequency;
  return (passed + reflection_time(bar)) / 2;
}

double analytic_stress(const ThesisBar& bar, double time, double place) {
  return exact::exact_bar_stress({bar.load_amplitude, bar.load_frequency}, time, place, bar.wave_speed(), bar.height);
}

WavePicks pick_wave(const ThesisBar& bar, const std::vector<double>& history, double dt, double place) {
  const exact::Signal whole{history, dt, 0};
  const exact::Signal signal = exact::window(whole, 0, window_end(bar));
  const double longest_lag = 0.2 / bar.load_frequency;  // a fifth of a period: beyond it another half-wave would fit
  const exact::Correlation correlation = exact::correlation_lag(
      signal, [&](double time) { return analytic_stress(bar, time, place); }, -longest_lag, longest_lag);
  WavePicks picks;
  picks.half_range = exact::half_range(signal, 0, window_end(bar));
  picks.first_peak = -exact::first_peak(signal, exact::Polarity::negative).value;
  picks.onset_velocity = bar.measuring_point / exact::onset(signal, exact::Polarity::negative);
  picks.correlation_velocity = place / (place / bar.wave_speed() + correlation.lag);
  return picks;
}

}  // namespace verify
