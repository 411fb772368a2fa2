#include "verification/thesis/readings_study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "verification/exact/signal.h"
#include "verification/harness/recorded_run.h"
#include "verification/thesis/bar_scene.h"
#include "verification/thesis/wave_picks.h"

namespace verify {
namespace {

using History = std::vector<double>;

// sigma_x of the blocks to the right and to the left of the measuring point.
std::pair<History, History> both_sides(const ThesisBar& bar, const BarRun& run) {
  dda::Model model = bar_scene(bar, scheme_settings("thesis", bar), run);
  dda::Measurement left = model.measurements.front();
  left.name = "left";
  left.block -= 1;
  left.point.x() -= run.block_length / 2;
  model.measurements.push_back(left);
  dda::finish_model(model);
  RecordedRun recorded = record_run(model);
  return {std::move(recorded.histories[0]), std::move(recorded.histories[1])};
}

History mean_of(const History& a, const History& b) {
  History mean(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) mean[i] = (a[i] + b[i]) / 2;
  return mean;
}

// Velocity from the time of the first peak: it left the loaded end a quarter of a period after the load's start.
double peak_velocity(const ThesisBar& bar, const History& history, double dt) {
  const double time = exact::first_peak({history, dt, 0}, exact::Polarity::negative).time;
  return bar.measuring_point / (time - 0.25 / bar.load_frequency);
}

void worsen(double& worst_pct, double value, double printed) {
  worst_pct = std::max(worst_pct, 100 * std::abs(value / printed - 1));
}

void add(ReadingResult& result, double amplitude, double velocity, const PrintedResult& printed) {
  worsen(result.amplitude_pct, amplitude / 1e3, printed.amplitude_kpa);
  worsen(result.velocity_pct, velocity, printed.velocity);
}

}  // namespace

std::vector<ReadingResult> readings_study(const ThesisReference& reference, const std::vector<double>& time_steps,
                                          double duration) {
  const ThesisBar& bar = reference.bar;
  std::vector<ReadingResult> results = {{"block to the right of 50 m", "half the range", "onset"},
                                        {"block to the right of 50 m", "first peak", "time of the first peak"},
                                        {"block to the left of 50 m", "half the range", "onset"},
                                        {"mean of both blocks", "half the range", "onset"}};
  for (const double dt : time_steps) {
    for (const double length : reference.block_lengths) {
      const PrintedResult& printed = reference.at(dt, length);
      const auto [right, left] = both_sides(bar, {dt, length, bar.length, duration});
      const WavePicks picks = pick_wave(bar, right, dt, bar.measuring_point);
      const WavePicks left_picks = pick_wave(bar, left, dt, bar.measuring_point);
      const WavePicks mean_picks = pick_wave(bar, mean_of(right, left), dt, bar.measuring_point);
      add(results[0], picks.half_range, picks.onset_velocity, printed);
      add(results[1], picks.first_peak, peak_velocity(bar, right, dt), printed);
      add(results[2], left_picks.half_range, left_picks.onset_velocity, printed);
      add(results[3], mean_picks.half_range, mean_picks.onset_velocity, printed);
    }
  }
  return results;
}

}  // namespace verify
