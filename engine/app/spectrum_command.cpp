#include "engine/app/spectrum_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include "engine/app/moving_part.h"
#include "engine/app/output_file.h"
#include "engine/core/error.h"
#include "engine/core/quantity.h"
#include "engine/record/atomic_file.h"
#include "engine/record/csv.h"
#include "engine/record/run_folder.h"
#include "engine/scene/nearest_word.h"
#include "engine/spectra/response_spectrum.h"
#include "engine/view/run_facts.h"

namespace dda {
namespace {

constexpr auto details =
    "How far oscillators of all periods swing on ground that moves as a measurement says. FILE gets a row a period:\n"
    "Sd, the largest displacement against the ground, Sv = omega Sd and Sa = omega^2 Sd (pseudo-velocity and pseudo-\n"
    "acceleration), for every damping. Periods are spaced evenly in their logarithm.\n\n"
    "Examples:\n"
    "  dda spectrum results --measurement crest\n"
    "  dda spectrum results --measurement crest --damping 0.05,0.02 --periods 0.01,2 --out crest.csv\n";

constexpr std::size_t most_periods = 100'000;
constexpr double shortest_period = 1e-12, longest_period = 1e12;  // s: omega^2 stays far within the range of numbers

// A number, or one with a unit.
double number_in(const std::string& text, Dimension dimension, const char* option) {
  if (const auto plain = csv_number(text)) return *plain;
  return parse_quantity(text, dimension, option);
}

double damping_of(const std::string& text) {
  const double ratio = number_in(text, Dimension::dimensionless, "--damping");
  if (!(ratio >= 0 && ratio < 1))
    throw InputError("", "--damping", text, "shares of critical damping from 0 to below 1, like 0.05,0.02");
  return ratio + 0.0;  // no "-0" in the headings
}

std::size_t count_of(const std::string& text) {
  const auto count = csv_number(text);
  if (!count || !(*count >= 2 && *count <= static_cast<double>(most_periods)) || *count != std::floor(*count))
    throw InputError("", "--count", '"' + text + '"', fmt::format("a whole number from 2 to {}", most_periods));
  return static_cast<std::size_t>(*count);
}

bool is_motion(const HistoryColumn& column) {
  return column.unit == "m" || column.unit == "m/s" || column.unit == "m/s2";
}

GroundMotion motion_of(const HistoryColumn& column) {
  if (column.unit == "m") return GroundMotion::displacement;
  return column.unit == "m/s" ? GroundMotion::velocity : GroundMotion::acceleration;
}

[[noreturn]] void refuse_measurement(const std::string& name, const std::string& unit, const Histories& histories) {
  std::vector<std::string> motions;
  for (const HistoryColumn& column : histories.columns)
    if (is_motion(column)) motions.push_back(column.name);
  const std::string meant = nearest_word(name, motions);
  const std::string hint = meant.empty() ? "" : fmt::format(" (\"{}\"?)", meant);
  throw InputError("", "--measurement", fmt::format("\"{}\"{}", name, unit.empty() ? "" : " in " + unit),
                   fmt::format("a displacement, velocity or acceleration of the run{}: {}", hint,
                               motions.empty() ? "it has measured none" : fmt::format("{}", fmt::join(motions, ", "))));
}

const HistoryColumn& measured(const std::string& name, const Histories& histories) {
  const auto column = std::ranges::find(histories.columns, name, &HistoryColumn::name);
  if (column == histories.columns.end()) refuse_measurement(name, "", histories);
  if (!is_motion(*column)) refuse_measurement(name, column->unit, histories);
  return *column;
}

MotionRecord record_of(const SpectrumRequest& request) {
  const RunFacts facts = read_facts(request.folder);
  const std::string file = (request.folder / histories_name).string();
  if (!facts.histories) throw InputError(file, "the file", "missing", "the measurements of a run that has ended");
  const Histories histories = from(first_moment(facts.summary), *facts.histories);
  const HistoryColumn& column = measured(request.measurement, histories);
  if (!std::ranges::is_sorted(histories.times))
    throw InputError(file, "the file", "damaged (times fall)", "the measurements that dda run writes");
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(column.values, is_finite) || !std::ranges::all_of(histories.times, is_finite))
    throw InputError(file, "measurement \"" + column.name + "\"", "not finite everywhere", "numbers");
  const GroundMotion kind = motion_of(column);
  if (kind != GroundMotion::displacement) return {kind, histories.times, column.values};
  return {kind, histories.times, without_jumps(histories.times, column.values)};
}

PeriodRange given_range(const std::vector<std::string>& periods) {
  const std::string given = fmt::format("{}", fmt::join(periods, ","));
  PeriodRange range;
  if (periods.size() == 2)
    range = {number_in(periods[0], Dimension::time, "--periods"), number_in(periods[1], Dimension::time, "--periods")};
  if (!(range.shortest >= shortest_period && range.longest > range.shortest && range.longest <= longest_period))
    throw InputError("", "--periods", '"' + given + '"',
                     "SHORTEST,LONGEST in s, two times above 0, the shorter one first");
  return range;
}

PeriodRange range_of(const SpectrumRequest& request, const MotionRecord& record) {
  if (!request.periods.empty()) return given_range(request.periods);
  const PeriodRange range = resolved_periods(record.times);
  if (range.longest <= range.shortest)
    throw InputError((request.folder / histories_name).string(), "the number of rows in motion",
                     std::to_string(record.times.size()),
                     "more than ten, as a period takes ten at least, or --periods SHORTEST,LONGEST");
  return range;
}

std::string heading(const std::vector<double>& ratios) {
  std::string line = "period [s],frequency [Hz]";
  for (const double ratio : ratios)
    line += fmt::format(",Sd {0:.12g} % [m],Sv {0:.12g} % [m/s],Sa {0:.12g} % [m/s2]", 100 * ratio);
  return line + "\n";
}

struct Peak {
  double acceleration = 0, period = 0;
};

// Another name than those of a run's own tables, which would be gone.
void check_name(const std::filesystem::path& file, const std::filesystem::path& folder_of_run) {
  const std::filesystem::path name = file.filename();
  const bool is_of_a_run = name == histories_name || name == energies_name || name == peaks_name;
  if (file.extension() != ".csv" || is_of_a_run)
    throw InputError("", "--out", file.string(), "a name that ends in .csv and is none of a run's own files");
  expect_output(file, folder_of_run);
}

// The rows of the file; `peaks`: the largest Sa of every damping.
std::string table_of(const MotionRecord& record, const std::vector<double>& periods, const std::vector<double>& ratios,
                     std::vector<Peak>& peaks) {
  peaks.assign(ratios.size(), {});
  std::string rows = heading(ratios);
  for (const double period : periods) {
    const double omega = 2 * std::numbers::pi / period;
    rows += fmt::format("{},{}", period, 1 / period);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const double displacement = spectral_displacement(record, period, ratios[i]);
      const double acceleration = omega * omega * displacement;
      rows += fmt::format(",{},{},{}", displacement, omega * displacement, acceleration);
      if (acceleration > peaks[i].acceleration) peaks[i] = {acceleration, period};
    }
    rows += '\n';
  }
  return rows;
}

// What the measurement does not tell of periods that were asked for.
std::string unresolved(const PeriodRange& asked, const PeriodRange& resolved) {
  constexpr double round_off = 1e-9;  // of times that are sums of steps
  std::string text;
  if (asked.shortest < (1 - round_off) * resolved.shortest)
    text += fmt::format(
        "below {:.4g} s a period has less than ten rows of {}, and what moves so fast is not all in them: run with a "
        "smaller --every or dt\n",
        resolved.shortest, histories_name);
  if (asked.longest > (1 + round_off) * resolved.longest)
    text += fmt::format("above {:.4g} s a period takes longer than the measurement: what comes after it is left out\n",
                        resolved.longest);
  return text;
}

std::string in_words(double ratio, const Peak& peak) {
  const std::string damping = fmt::format("damping {:.12g} %: ", 100 * ratio);
  if (peak.acceleration == 0) return damping + "Sa is 0 at all periods, as nothing moves in the measurement\n";
  return damping + fmt::format("Sa is largest at {:.4g} s, {:.4g} m/s2\n", peak.period, peak.acceleration);
}

}  // namespace

void add_spectrum(CLI::App& app, SpectrumRequest& request) {
  CLI::App* command =
      app.add_subcommand("spectrum", "Make the response spectrum of a measured motion")->footer(details);
  const auto add = [command](const char* name, auto& value, const char* help, const char* type) {
    return command->add_option(name, value, help)->type_name(type);
  };
  add("folder", request.folder, "what dda run wrote", "DIR")->required();
  add("--measurement", request.measurement, "a displacement, velocity or acceleration of histories.csv", "NAME")
      ->required();
  add("--damping", request.damping, "shares of critical damping; default 0.05", "SHARE,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  add("--periods", request.periods, "the range of periods, s; default: ten rows to the whole time of the measurement",
      "SHORTEST,LONGEST")
      ->delimiter(',')
      ->allow_extra_args(false);
  add("--count", request.count, "of periods in it; default 100", "N");
  add("--out", request.file, "the file to write; default DIR/spectrum.csv", "FILE");
}

void write_spectrum(const SpectrumRequest& request, std::ostream& out) {
  const std::filesystem::path file = request.file.empty() ? request.folder / spectrum_name : request.file;
  check_name(file, request.folder);
  std::vector<double> ratios;
  for (const std::string& text : request.damping) {
    ratios.push_back(damping_of(text));
    if (std::ranges::count(ratios, ratios.back()) > 1)
      throw InputError("", "--damping", text + " a second time", "shares that differ, like 0.05,0.02");
  }
  const std::size_t count = count_of(request.count);
  const MotionRecord record = record_of(request);
  const PeriodRange range = range_of(request, record);
  std::vector<Peak> peaks;
  write_file(file, table_of(record, spaced_evenly_in_logarithm(range, count), ratios, peaks));
  out << fmt::format("{}: {} periods from {:.4g} to {:.4g} s\n", file.string(), count, range.shortest, range.longest);
  for (std::size_t i = 0; i < ratios.size(); ++i) out << in_words(ratios[i], peaks[i]);
  out << unresolved(range, resolved_periods(record.times));
}

}  // namespace dda
