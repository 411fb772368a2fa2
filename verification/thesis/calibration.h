// The calibration study: every scheme on every (dt, block length) of the thesis' tables, measured and judged.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "engine/linear/solver_choice.h"
#include "verification/thesis/oracle_study.h"
#include "verification/thesis/readings_study.h"
#include "verification/thesis/reference.h"
#include "verification/thesis/schemes.h"
#include "verification/thesis/wave_picks.h"

namespace verify {

struct CalibrationRow {
  std::string scheme;
  double dt = 0;            // s
  double block_length = 0;  // m
  double place = 0;         // m, where sigma_x was taken
  AmplitudeReading reading = AmplitudeReading::first_peak;
  WavePicks picks;
  WavePicks closed_form_picks;  // the same, read off the closed form of the discrete problem
  double oracle_max_rel_diff = 0;
  std::vector<double> history;  // Pa, at t = i dt
  PrintedResult printed;

  std::int64_t steps = 0;
  double setup_cpu_s = 0;  // least of the repetitions, as cpu_s
  double cpu_s = 0;
  std::int64_t factorizations = 0;
  std::int64_t matrix_rebuilds = 0;
  std::int64_t solver_iterations = 0;
  dda::SolverKind solver = dda::SolverKind::cholesky;
  double energy_residual_rel = 0;

  [[nodiscard]] double amplitude() const { return amplitude_of(picks); }  // Pa, by `reading`
  [[nodiscard]] double amplitude_of(const WavePicks& from) const;
  [[nodiscard]] double amplitude_error_pct() const;    // of the analytic amplitude
  [[nodiscard]] double correlation_error_pct() const;  // of sqrt(E/rho)
  // The difference in percent of the printed number; nothing for schemes other than "thesis".
  [[nodiscard]] std::optional<double> amplitude_vs_thesis_pct() const;
  [[nodiscard]] std::optional<double> velocity_vs_thesis_pct() const;
};

struct Calibration {
  ThesisBar bar;
  double duration = 0;  // s of every run
  int repetitions = 0;
  std::vector<double> time_steps;     // s
  std::vector<double> block_lengths;  // m
  std::vector<CalibrationRow> rows;   // by time step, scheme, block length
  std::vector<OracleResult> oracle;
  std::vector<ReadingResult> readings;

  // Throws std::out_of_range if there is no such row.
  [[nodiscard]] const CalibrationRow& at(std::string_view scheme, double dt, double block_length) const;
  [[nodiscard]] double total_cpu(std::string_view scheme) const;  // s
};

struct CalibrationOptions {
  bool quick = false;  // the larger time step only, each run once
  int repetitions = 5;
  std::ostream* progress = nullptr;  // a terminal, or none
};

// The bar, the time steps and the block lengths of the thesis' tables.
[[nodiscard]] Calibration calibration_without_rows();

// Runs of one (dt, block length) follow each other scheme by scheme, and all of them `repetitions` times, so that what
// disturbs a busy machine does not favour one.
[[nodiscard]] Calibration run_calibration(const CalibrationOptions& options = {});

// Makes one row from a single run.
[[nodiscard]] CalibrationRow calibrate_row(const SchemeSettings& scheme, double dt, double block_length);

}  // namespace verify
