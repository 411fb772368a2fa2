#include "verification/thesis/wave_picks.h"

#include <gtest/gtest.h>

namespace verify {
namespace {

std::vector<double> delayed_wave(const ThesisBar& bar, double dt, double place, double delay, double factor) {
  std::vector<double> history;
  for (double time = 0; time < 0.035; time = static_cast<double>(history.size()) * dt)
    history.push_back(factor * analytic_stress(bar, time - delay, place));
  return history;
}

TEST(WavePicks, AnalyticWaveHasTheAnalyticValues) {
  const ThesisBar& bar = thesis_reference().bar;
  const double dt = 1e-5;
  const WavePicks picks = pick_wave(bar, delayed_wave(bar, dt, 50, 0, 1), dt, 50);
  const double sampling = 1e6 * 0.5 * 0.0032 * 0.0032;  // a peak between samples: (omega dt/2)^2/2 of it
  EXPECT_NEAR(picks.half_range, 1e6, sampling);
  EXPECT_NEAR(picks.first_peak, 1e6, 0.01 * sampling);  // the parabola takes the sampling out
  EXPECT_NEAR(picks.correlation_velocity, bar.wave_speed(), 1e-6 * bar.wave_speed());
  EXPECT_NEAR(picks.onset_velocity, bar.wave_speed(), bar.wave_speed() * dt / 0.0115);  // one sample
}

TEST(WavePicks, LagSlowsTheCorrelationOnly) {
  const ThesisBar& bar = thesis_reference().bar;
  const double lag = 3.7e-4;
  const double place = 55;
  const WavePicks picks = pick_wave(bar, delayed_wave(bar, 1e-5, place, lag, 0.8), 1e-5, place);
  EXPECT_NEAR(picks.correlation_velocity, place / (place / bar.wave_speed() + lag), 0.005);
  EXPECT_NEAR(picks.first_peak, 0.8e6, 10);
}

TEST(WavePicks, WindowEndsBeforeTheReflection) {
  const ThesisBar& bar = thesis_reference().bar;
  EXPECT_NEAR(reflection_time(bar), 34.53e-3, 0.01e-3);
  EXPECT_NEAR(window_end(bar), 28.02e-3, 0.01e-3);
  const double dt = 1e-5;
  std::vector<double> history = delayed_wave(bar, dt, 50, 0, 1);
  const WavePicks before = pick_wave(bar, history, dt, 50);
  for (std::size_t i = 2810; i < history.size(); ++i) history[i] = 9e6;
  EXPECT_EQ(pick_wave(bar, history, dt, 50).half_range, before.half_range);
}

}  // namespace
}  // namespace verify
