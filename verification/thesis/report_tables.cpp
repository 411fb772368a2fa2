#include "verification/thesis/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace verify {
namespace {

std::string with_minus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) text.replace(at, 1, "−");
  return text;
}

// Calls add(dt, length) for each pair and marks where a time step begins.
template <typename Add>
void for_each_run(const Calibration& calibration, Table& table, const Add& add) {
  for (const double dt : calibration.time_steps) {
    if (!table.rows.empty()) table.breaks.push_back(static_cast<int>(table.rows.size()));
    for (const double length : calibration.block_lengths) add(dt, length);
  }
}

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) text += digits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

double percent(double value, double reference) { return 100 * (value / reference - 1); }

}  // namespace

std::string fixed(double value, int digits) { return with_minus(fmt::format("{:.{}f}", value, digits)); }

std::string signed_pct(double value, int digits) { return with_minus(fmt::format("{:+.{}f}", value, digits)); }

std::string scientific(double value) {
  const std::string text = fmt::format("{:.1e}", value);
  const std::size_t mark = text.find('e');
  if (mark == std::string::npos || value == 0) return value == 0 ? "0" : text;
  return text.substr(0, mark) + "·10" + superscript(std::stoi(text.substr(mark + 1)));
}

std::string milliseconds(double seconds) { return fmt::format("{:g}", seconds * 1e3); }

Table amplitude_table(const Calibration& calibration) {
  Table table;
  table.caption =
      "**Table 3.2**: amplitude of σₓ at 50 m, in kPa; the analytic value is 1000 kPa. Thesis scheme: half the range. "
      "Accurate scheme: first peak. Closed form: the same reading of the exact solution of the discrete problem.";
  table.groups = {{"", 3}, {"thesis", 1}, {"this engine, thesis scheme", 3}, {"this engine, accurate scheme", 3}};
  table.header = {"Δt (ms)",       "Δx (m)",      "η",         "printed",   "amplitude",
                  "vs. print (%)", "closed form", "amplitude", "error (%)", "closed form"};
  for_each_run(calibration, table, [&](double dt, double length) {
    const CalibrationRow& thesis = calibration.at("thesis", dt, length);
    const CalibrationRow& accurate = calibration.at("accurate", dt, length);
    table.rows.push_back({milliseconds(dt), fmt::format("{:g}", length), fixed(calibration.bar.eta(length), 3),
                          fixed(thesis.printed.amplitude_kpa, 1), fixed(thesis.amplitude() / 1e3, 1),
                          signed_pct(thesis.amplitude_vs_thesis_pct().value()),
                          fixed(thesis.amplitude_of(thesis.closed_form_picks) / 1e3, 1),
                          fixed(accurate.amplitude() / 1e3, 1), signed_pct(accurate.amplitude_error_pct(), 3),
                          fixed(accurate.amplitude_of(accurate.closed_form_picks) / 1e3, 1)});
  });
  return table;
}

Table velocity_table(const Calibration& calibration) {
  Table table;
  table.caption = fmt::format(
      "**Table 3.3**: wave velocity over the first 50 m, in m/s; the analytic value is {:.2f} m/s. Thesis scheme: "
      "onset. "
      "Accurate scheme: cross-correlation with the analytic stress.",
      calibration.bar.wave_speed());
  table.groups = {{"", 3}, {"thesis", 1}, {"this engine, thesis scheme", 3}, {"this engine, accurate scheme", 3}};
  table.header = {"Δt (ms)",       "Δx (m)",      "η",        "printed",   "velocity",
                  "vs. print (%)", "closed form", "velocity", "error (%)", "closed form"};
  for_each_run(calibration, table, [&](double dt, double length) {
    const CalibrationRow& thesis = calibration.at("thesis", dt, length);
    const CalibrationRow& accurate = calibration.at("accurate", dt, length);
    table.rows.push_back(
        {milliseconds(dt), fmt::format("{:g}", length), fixed(calibration.bar.eta(length), 3),
         fixed(thesis.printed.velocity, 2), fixed(thesis.picks.onset_velocity, 2),
         signed_pct(thesis.velocity_vs_thesis_pct().value()), fixed(thesis.closed_form_picks.onset_velocity, 2),
         fixed(accurate.picks.correlation_velocity, 2), signed_pct(accurate.correlation_error_pct(), 3),
         fixed(accurate.closed_form_picks.correlation_velocity, 2)});
  });
  return table;
}

Table scheme_table() {
  Table table;
  table.numeric = false;
  table.header = {"scheme", "what it is"};
  for (const std::string_view name : scheme_names())
    table.rows.push_back({fmt::format("`{}`", name), scheme_settings(name).description});
  return table;
}

Table readings_table(const Calibration& calibration) {
  Table table;
  table.numeric = false;
  table.header = {"quantity", "how it is read", "why so"};
  table.rows = {
      {"place", "`thesis` and `classical_trapezoidal`: the block to the right of 50 m; the others: 50 m itself",
       "50 m is always a joint. A block has one stress, the mean over its length, which belongs to its middle and is "
       "lower than the peak by sin(πη)/(πη): 2 % for 5 m, 8 % for 10 m. So the accurate scheme reports the stress at "
       "the point."},
      {"amplitude, half range",
       fmt::format("(largest − smallest)/2 of σₓ up to {:.1f} ms", window_end(calibration.bar) * 1e3),
       "What the print shows. The window ends half-way between the moment the pulse has passed 50 m and the moment its "
       "reflection returns, in every row; any end from 22 to 31 ms gives the same numbers."},
      {"amplitude, first peak",
       "first compressive extreme beyond half of the largest, by a parabola through three samples",
       "The wave's own amplitude, before trailing oscillations add to it. Accuracy is graded by it."},
      {"velocity, onset", "50 m over the time of the last change of sign before the first peak",
       "What the print shows, also where it exceeds √(E/ρ): it sees the foot of a front that damping has spread."},
      {"velocity, correlation",
       "x/(x/c + lag): the lag behind the analytic stress at the same place x (50 m, or the "
       "middle of the block) that maximises their cross-correlation",
       "Uses the whole pulse and hardly depends on the time step. Accuracy is graded by it."},
      {"η", "Δx/λ with λ = c/f = 43.44 m", "Eq. 16 of the thesis."},
  };
  return table;
}

Table other_readings_table(const Calibration& calibration) {
  Table table;
  table.numeric = false;
  table.caption =
      "Readings that were tried on the thesis scheme: the largest difference from the printed numbers, over all of "
      "them. "
      "The first is the one used.";
  table.header = {"place", "amplitude", "velocity", "off Table 3.2 (%)", "off Table 3.3 (%)"};
  for (const ReadingResult& reading : calibration.readings)
    table.rows.push_back({reading.place, reading.amplitude, reading.velocity, fixed(reading.amplitude_pct, 2),
                          fixed(reading.velocity_pct, 2)});
  return table;
}

Table schemes_error_table(const Calibration& calibration) {
  Table table;
  table.caption =
      "Errors in % of all schemes: first-peak amplitude / correlation velocity, each against the analytic value at "
      "the place where the scheme's stress is taken.";
  table.header = {"scheme", "Δt (ms)"};
  for (const double length : calibration.block_lengths) table.header.push_back(fmt::format("{:g} m", length));
  for (const std::string_view name : scheme_names()) {
    if (!table.rows.empty()) table.breaks.push_back(static_cast<int>(table.rows.size()));
    for (const double dt : calibration.time_steps) {
      std::vector<std::string> cells = {std::string(scheme_settings(name).title), milliseconds(dt)};
      for (const double length : calibration.block_lengths) {
        const CalibrationRow& row = calibration.at(name, dt, length);
        cells.push_back(signed_pct(percent(row.picks.first_peak, calibration.bar.incident_stress())) + " / " +
                        signed_pct(row.correlation_error_pct()));
      }
      table.rows.push_back(cells);
    }
  }
  return table;
}

Table oracle_table(const Calibration& calibration) {
  Table table;
  table.caption = fmt::format(
      "Largest difference between the engine's σₓ history and the closed form of the same discrete chain, in units of "
      "the peak; bar of {:g} m, Δt = 0.1 ms, {:g} ms.",
      2 * calibration.bar.length, calibration.duration * 1e3);
  table.header = {"interface law, integrator"};
  for (const double length : calibration.block_lengths) table.header.push_back(fmt::format("{:g} m", length));
  std::string law;
  for (std::size_t i = 0; i < calibration.oracle.size(); i += calibration.block_lengths.size()) {
    const OracleResult& first = calibration.oracle[i];
    if (first.law != law && i > 0) table.breaks.push_back(static_cast<int>(table.rows.size()));
    law = first.law;
    std::vector<std::string> cells = {first.law + ", " + first.integrator};
    for (std::size_t j = 0; j < calibration.block_lengths.size(); ++j)
      cells.push_back(scientific(calibration.oracle[i + j].max_rel_diff));
    table.rows.push_back(cells);
  }
  return table;
}

Table counters_table(const Calibration& calibration) {
  Table table;
  table.caption =
      "Every row: what the solver did, the residual of the energy balance, the difference from the closed form.";
  table.header = {"scheme",          "Δt (ms)",          "Δx (m)",          "steps",
                  "solver",          "factorizations",   "matrix rebuilds", "solver iterations",
                  "energy residual", "oracle difference"};
  for (std::size_t i = 0; i < calibration.rows.size(); ++i) {
    const CalibrationRow& row = calibration.rows[i];
    if (i > 0 && row.scheme != calibration.rows[i - 1].scheme) table.breaks.push_back(static_cast<int>(i));
    table.rows.push_back({scheme_settings(row.scheme).title, milliseconds(row.dt),
                          fmt::format("{:g}", row.block_length), fmt::format("{}", row.steps),
                          std::string(to_string(row.solver)), fmt::format("{}", row.factorizations),
                          fmt::format("{}", row.matrix_rebuilds), fmt::format("{}", row.solver_iterations),
                          scientific(row.energy_residual_rel), scientific(row.oracle_max_rel_diff)});
  }
  return table;
}

Table cpu_table(const Calibration& calibration) {
  Table table;
  table.caption =
      fmt::format("CPU time of the stepping loop in ms, one thread, least of {} run{}; {:g} ms of simulated time.",
                  calibration.repetitions, calibration.repetitions == 1 ? "" : "s", calibration.duration * 1e3);
  table.header = {"scheme", "Δt (ms)"};
  for (const double length : calibration.block_lengths) table.header.push_back(fmt::format("{:g} m", length));
  table.header.emplace_back("sum");
  for (const std::string_view name : scheme_names()) {
    if (!table.rows.empty()) table.breaks.push_back(static_cast<int>(table.rows.size()));
    for (const double dt : calibration.time_steps) {
      std::vector<std::string> cells = {scheme_settings(name).title, milliseconds(dt)};
      double sum = 0;
      for (const double length : calibration.block_lengths) {
        const double cpu = calibration.at(name, dt, length).cpu_s;
        sum += cpu;
        cells.push_back(fixed(cpu * 1e3, 2));
      }
      cells.push_back(fixed(sum * 1e3, 1));
      table.rows.push_back(cells);
    }
  }
  return table;
}

Table promises_table(const std::vector<Promise>& promises) {
  Table table;
  table.numeric = false;
  table.caption = "Checked by every run; the program fails, and names the row, if one is broken.";
  table.header = {"", "promise", "worst case measured"};
  for (const Promise& promise : promises)
    table.rows.push_back({promise.kept() ? "✓" : "✗ broken", promise.claim, promise.measured});
  return table;
}

}  // namespace verify
