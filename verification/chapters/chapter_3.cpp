#include "verification/chapters/chapter_3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

enum class Read { amplitude, velocity };
constexpr Read both[] = {Read::amplitude, Read::velocity};

const char* name_of(Read what) { return what == Read::amplitude ? "amplitude" : "velocity"; }
const char* table_of(Read what) { return what == Read::amplitude ? "Table 3.2" : "Table 3.3"; }

// Eq. 15 for the rows of the thesis' scheme, read as its tables are, %.
double error_pct(const CalibrationRow& row, Read what, const ThesisBar& bar) {
  if (what == Read::amplitude) return std::abs(row.amplitude_error_pct());
  return 100 * std::abs(row.picks.onset_velocity / bar.wave_speed() - 1);
}

double printed_error_pct(const CalibrationRow& row, Read what, const ThesisBar& bar) {
  if (what == Read::amplitude) return 100 * std::abs(1e3 * row.printed.amplitude_kpa / bar.incident_stress() - 1);
  return 100 * std::abs(row.printed.velocity / bar.wave_speed() - 1);
}

std::vector<double> errors(const Calibration& c, double dt, Read what) {
  std::vector<double> all;
  for (const double length : c.block_lengths) all.push_back(error_pct(c.at("thesis", dt, length), what, c.bar));
  return all;
}

std::string listed(const std::vector<double>& percents) {
  std::string text;
  for (const double value : percents) text += fmt::format("{}{:.2f}", text.empty() ? "" : ", ", value);
  return text + " %";
}

double fine(const Calibration& c) { return std::ranges::min(c.time_steps); }
std::string ms(double dt) { return fmt::format("{:g} ms", 1e3 * dt); }

// Each table at each time step.
std::vector<Reading> readings(const Calibration& c, const auto& judge) {
  std::vector<Reading> all;
  for (const Read what : both)
    for (const double dt : c.time_steps) {
      Reading reading = judge(dt, what);
      reading.name = fmt::format("{} at {}", name_of(what), ms(dt));
      all.push_back(std::move(reading));
    }
  return all;
}

Statement table_is_reproduced(const Calibration& c, double dt, Read what) {
  double worst = 0;
  double where = 0;
  for (const double length : c.block_lengths) {
    const CalibrationRow& row = c.at("thesis", dt, length);
    const auto off = what == Read::amplitude ? row.amplitude_vs_thesis_pct() : row.velocity_vs_thesis_pct();
    if (!(std::abs(off.value()) <= std::abs(worst))) worst = *off, where = length;
  }
  constexpr double tolerance = 0.5;
  return {3,
          fmt::format("3-{}-{:g}us", name_of(what), 1e6 * dt),
          fmt::format("{}, the five values of the {} at a time step of {}", table_of(what), name_of(what), ms(dt)),
          0.0,
          std::abs(worst),
          "% off the printed values at most",
          std::abs(worst) <= tolerance,
          fmt::format("The largest deviation is {:+.2f} %, with blocks of {:g} m. Tolerance {} %, the promise of the "
                      "calibration study; other readings of the same histories miss the tables by up to 14 to 23 % "
                      "(verification/thesis/README.md).",
                      worst, where, tolerance)};
}

Statement some_error_below_2(const Calibration& c) {
  double best = INFINITY;
  double where = 0;
  for (const double length : c.block_lengths) {
    const CalibrationRow& row = c.at("thesis", fine(c), length);
    const double larger = std::max(error_pct(row, Read::amplitude, c.bar), error_pct(row, Read::velocity, c.bar));
    if (larger < best) best = larger, where = length;
  }
  return {3,
          "3-below-2-percent",
          "DDA can be accurate to less than 2 % with a suitable time step and block length",
          2.0,
          best,
          "% error at most",
          best < 2,
          fmt::format("With blocks of {:g} m and a time step of {} the larger of the errors of amplitude and velocity "
                      "is {:.2f} %. The limit is the thesis' own.",
                      where, ms(fine(c)), best)};
}

Statement optimum(const Calibration& c) {
  const auto all = readings(c, [&](double dt, Read what) {
    const std::vector<double> found = errors(c, dt, what);
    const double length = c.block_lengths[static_cast<std::size_t>(std::ranges::min_element(found) - found.begin())];
    const double eta = c.bar.eta(length);
    return Reading{
        "", eta >= 1.0 / 12 && eta <= 1.0 / 8,
        fmt::format("least error {:.2f} % at {:g} m, eta 1/{:.0f}", std::ranges::min(found), length, 1 / eta)};
  });
  return judged_over({3, "3-optimum",
                      "Errors are least for block lengths between 1/12 and 1/8 of the wavelength (Lysmer and "
                      "Kuhlemeyer)",
                      std::string("eta from 1/12 to 1/8"), "", "", std::nullopt,
                      "Of the five lengths the one with the least error must lie in that range, in each table and for "
                      "each time step. In the tables as printed the best are the same: the optimum is where the "
                      "compliance of springs of 10 E and the dispersion of long blocks cancel."},
                     all);
}

Statement grows_for_smaller(const Calibration& c) {
  const auto all = readings(c, [&](double dt, Read what) {
    const std::vector<double> found = errors(c, dt, what);
    return Reading{"", std::ranges::is_sorted(found, std::greater<>()), "0.5 to 10 m: " + listed(found)};
  });
  return judged_over({3, "3-smaller-blocks", "As the size of the blocks decreases, the relative error increases",
                      std::string("errors fall from 0.5 to 10 m"), "", "", std::nullopt,
                      "The errors of the five lengths must fall from each to the next longer one."},
                     all);
}

Statement smaller_steps(const Calibration& c) {
  std::vector<Reading> all;
  for (const Read what : both)
    for (const double length : c.block_lengths) {
      const double small = error_pct(c.at("thesis", fine(c), length), what, c.bar);
      const double large = error_pct(c.at("thesis", std::ranges::max(c.time_steps), length), what, c.bar);
      all.push_back({fmt::format("{}, {:g} m", name_of(what), length), small < large,
                     fmt::format("{:.2f} % against {:.2f} %", small, large)});
    }
  return judged_over({3, "3-smaller-steps", "The smaller of the two time steps is the more accurate one",
                      std::string("for all lengths"), "", "", std::nullopt,
                      "Errors at 0.01 ms against those at 0.1 ms, for each table and block length."},
                     all);
}

// A cause explains an effect here if without it less than half of the effect is left.
constexpr double explained = 0.5;

Statement velocity_is_lost_to_springs(const Calibration& c) {
  const double length = c.block_lengths.front();
  const double with = std::abs(c.at("classical_trapezoidal", fine(c), length).correlation_error_pct());
  const double without = std::abs(c.at("consistent", fine(c), length).correlation_error_pct());
  return {
      3,
      "3-springs-velocity",
      "Small blocks lose accuracy of the velocity because there are more contact springs",
      std::string("springs are the cause"),
      fmt::format("{:.2f} % with springs, {:.2f} % without", with, without),
      "",
      without < explained * with,
      fmt::format("Blocks of {:g} m at {}, velocity by correlation, with the thesis' springs and with joints that have "
                  "none, both under the trapezoidal rule. Less than half of the error may be left without springs.",
                  length, ms(fine(c)))};
}

Statement amplitude_is_lost_to_springs(const Calibration& c) {
  const double length = c.block_lengths.front();
  const double error = error_pct(c.at("thesis", fine(c), length), Read::amplitude, c.bar);
  const double other_steps = error_pct(c.at("classical_trapezoidal", fine(c), length), Read::amplitude, c.bar);
  return {
      3,
      "3-springs-amplitude",
      "Small blocks lose accuracy of the amplitude because there are more contact springs",
      std::string("springs are the cause"),
      fmt::format("{:.2f} % under Eq. 5, {:.2f} % with the same springs under the trapezoidal rule", error,
                  other_steps),
      "",
      other_steps > explained * error,
      fmt::format("Blocks of {:g} m at {}: the springs stay and Eq. 5 is replaced by the trapezoidal rule. More than "
                  "half of the error would have to stay with the springs; what goes with Eq. 5 is its numerical "
                  "damping.",
                  length, ms(fine(c)))};
}

Statement printed_errors(const Calibration& c) {
  std::vector<Reading> all;
  for (const double dt : c.time_steps)
    for (const double length : c.block_lengths) {
      const CalibrationRow& row = c.at("thesis", dt, length);
      const double ours = error_pct(row, Read::amplitude, c.bar);
      const double printed = printed_error_pct(row, Read::amplitude, c.bar);
      all.push_back({fmt::format("{:g} m at {}", length, ms(dt)), std::abs(ours - printed) <= 0.5,
                     fmt::format("{:.2f} % against {:.2f} %", ours, printed)});
    }
  return judged_over({3, "3-printed-errors", "The errors of amplitude as Table 3.2 prints them",
                      std::string("ten errors"), "", "", std::nullopt,
                      "Errors by Eq. 15 within 0.5 percentage points of those of the printed amplitudes, the "
                      "tolerance of the tables themselves."},
                     all);
}

Table comparison(const Calibration& c) {
  Table table{
      "Errors of amplitude and velocity, %: the thesis' scheme as its tables read them, and the accurate scheme "
      "by first peak and correlation",
      {},
      {"blocks", "time step", "thesis, printed", "thesis scheme", "accurate scheme"},
      {},
      true,
      {}};
  for (const double dt : c.time_steps)
    for (const double length : c.block_lengths) {
      const CalibrationRow& row = c.at("thesis", dt, length);
      const CalibrationRow& accurate = c.at("accurate", dt, length);
      const auto pair = [](double a, double b) { return fmt::format("{:.2f}, {:.2f}", a, b); };
      table.rows.push_back(
          {fmt::format("{:g} m", length), ms(dt),
           pair(printed_error_pct(row, Read::amplitude, c.bar), printed_error_pct(row, Read::velocity, c.bar)),
           pair(error_pct(row, Read::amplitude, c.bar), error_pct(row, Read::velocity, c.bar)),
           pair(std::abs(accurate.amplitude_error_pct()), std::abs(accurate.correlation_error_pct()))});
    }
  return table;
}

}  // namespace

Calibration chapter_3_rows() {
  Calibration calibration = calibration_without_rows();
  for (const double dt : calibration.time_steps)
    for (const char* scheme : {"thesis", "classical_trapezoidal", "consistent", "accurate"})
      for (const double length : calibration.block_lengths)
        calibration.rows.push_back(calibrate_row(scheme_settings(scheme), dt, length));
  return calibration;
}

Chapter chapter_3(const Calibration& calibration) {
  Chapter chapter;
  chapter.number = 3;
  chapter.title = "Chapter 3: the P wave in a bar";
  for (const Read what : both)
    for (const double dt : calibration.time_steps)
      chapter.statements.push_back(table_is_reproduced(calibration, dt, what));
  chapter.statements.push_back(printed_errors(calibration));
  chapter.statements.push_back(some_error_below_2(calibration));
  chapter.statements.push_back(optimum(calibration));
  chapter.statements.push_back(grows_for_smaller(calibration));
  chapter.statements.push_back(velocity_is_lost_to_springs(calibration));
  chapter.statements.push_back(amplitude_is_lost_to_springs(calibration));
  chapter.statements.push_back(smaller_steps(calibration));
  chapter.assumptions = {
      "contact springs: 10 E at each corner, shear 0.4 of it (chapter 6 states 10 E; chapter 3 nothing)",
      "plane stress; fully dynamic (k01 = 1); small displacements; the load is spread over the end face",
      "sigma_x of the block to the right of 50 m; amplitude = half of its range before the end's reflection; velocity "
      "= "
      "50 m over the time of the last change of sign before the first peak"};
  chapter.sections.push_back({"Errors side by side", {comparison(calibration)}});
  return chapter;
}

}  // namespace verify
