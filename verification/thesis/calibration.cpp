#include "verification/thesis/calibration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/study/job_progress.h"
#include "verification/thesis/bar_scene.h"
#include "verification/thesis/closed_form.h"

namespace verify {
namespace {

constexpr double oracle_dt = 1e-4;  // s; the rows themselves cover the smaller step

double percent(double value, double reference) { return 100 * (value / reference - 1); }

// Long enough that the first of the reflection is in the history and is judged by the oracle too. A whole number of ms.
double run_duration(const ThesisBar& bar) { return std::ceil(1000 * reflection_time(bar)) / 1000; }

dda::Model scene(const ThesisBar& bar, const SchemeSettings& scheme, double dt, double length) {
  return bar_scene(bar, scheme, {dt, length, bar.length, run_duration(bar)});
}

CalibrationRow row_of(const ThesisBar& bar, const SchemeSettings& scheme, const dda::Model& model, RecordedRun run,
                      double length) {
  CalibrationRow row;
  row.scheme = scheme.name;
  row.dt = run.dt;
  row.block_length = length;
  row.place = measured_place(bar, scheme, length);
  row.reading = scheme.reading;
  row.printed = thesis_reference().at(run.dt, length);
  row.history = std::move(run.histories.front());
  row.picks = pick_wave(bar, row.history, run.dt, row.place);
  const std::vector<double> exact = closed_form_history(model, bar);
  row.closed_form_picks = pick_wave(bar, exact, run.dt, row.place);
  row.oracle_max_rel_diff = largest_difference(row.history, exact);
  row.steps = run.counters.steps;
  row.setup_cpu_s = run.setup_cpu_s;
  row.cpu_s = run.cpu_s;
  row.factorizations = run.counters.factorizations;
  row.matrix_rebuilds = run.counters.matrix_rebuilds;
  row.solver_iterations = run.counters.solver_iterations;
  row.solver = run.solver;
  row.energy_residual_rel = std::abs(run.energy.relative_residual());
  return row;
}

void time_again(const ThesisBar& bar, CalibrationRow& row) {
  const RecordedRun run = record_run(scene(bar, scheme_settings(row.scheme, bar), row.dt, row.block_length));
  row.cpu_s = std::min(row.cpu_s, run.cpu_s);
  row.setup_cpu_s = std::min(row.setup_cpu_s, run.setup_cpu_s);
}

}  // namespace

double CalibrationRow::amplitude_of(const WavePicks& from) const {
  return reading == AmplitudeReading::half_range ? from.half_range : from.first_peak;
}

double CalibrationRow::amplitude_error_pct() const {
  return percent(amplitude(), thesis_reference().bar.incident_stress());
}

double CalibrationRow::correlation_error_pct() const {
  return percent(picks.correlation_velocity, thesis_reference().bar.wave_speed());
}

std::optional<double> CalibrationRow::amplitude_vs_thesis_pct() const {
  if (scheme != "thesis") return std::nullopt;
  return percent(amplitude() / 1e3, printed.amplitude_kpa);
}

std::optional<double> CalibrationRow::velocity_vs_thesis_pct() const {
  if (scheme != "thesis") return std::nullopt;
  return percent(picks.onset_velocity, printed.velocity);
}

const CalibrationRow& Calibration::at(std::string_view scheme, double dt, double block_length) const {
  for (const CalibrationRow& row : rows)
    if (row.scheme == scheme && row.dt == dt && row.block_length == block_length) return row;
  throw std::out_of_range("no such row of the calibration");
}

double Calibration::total_cpu(std::string_view scheme) const {
  double total = 0;
  for (const CalibrationRow& row : rows)
    if (row.scheme == scheme) total += row.cpu_s;
  return total;
}

CalibrationRow calibrate_row(const SchemeSettings& scheme, double dt, double block_length) {
  const ThesisBar& bar = thesis_reference().bar;
  const dda::Model model = scene(bar, scheme, dt, block_length);
  return row_of(bar, scheme, model, record_run(model), block_length);
}

Calibration calibration_without_rows() {
  const ThesisReference& reference = thesis_reference();
  Calibration result;
  result.bar = reference.bar;
  result.block_lengths = reference.block_lengths;
  result.time_steps = reference.time_steps;
  return result;
}

Calibration run_calibration(const CalibrationOptions& options) {
  const ThesisReference& reference = thesis_reference();
  Calibration result = calibration_without_rows();
  result.duration = run_duration(reference.bar);
  result.repetitions = options.quick ? 1 : options.repetitions;
  if (options.quick) result.time_steps = {std::ranges::max(reference.time_steps)};

  const std::size_t rows = result.time_steps.size() * scheme_names().size() * result.block_lengths.size();
  const std::size_t runs = rows * static_cast<std::size_t>(result.repetitions) + oracle_runs(reference, 1);
  JobProgress progress(runs, options.progress);
  for (const double dt : result.time_steps) {
    for (const std::string_view scheme : scheme_names()) {
      for (const double length : result.block_lengths) {
        result.rows.push_back(calibrate_row(scheme_settings(scheme), dt, length));
        progress.job_ended();
      }
    }
  }
  for (int repetition = 1; repetition < result.repetitions; ++repetition) {
    for (const double dt : result.time_steps) {
      for (std::size_t column = 0; column < result.block_lengths.size(); ++column) {
        for (CalibrationRow& row : result.rows) {
          if (row.dt != dt || row.block_length != result.block_lengths[column]) continue;
          time_again(reference.bar, row);
          progress.job_ended();
        }
      }
    }
  }
  result.oracle = oracle_study(reference, {oracle_dt}, result.duration, [&] { progress.job_ended(); });
  result.readings = readings_study(reference, result.time_steps, result.duration);
  return result;
}

}  // namespace verify
