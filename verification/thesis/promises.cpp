#include "verification/thesis/promises.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace verify {
namespace {

// The project's own targets.
constexpr double thesis_limit_pct = 0.5;
constexpr double oracle_limit = 1e-9;
constexpr double energy_limit = 1e-9;

std::string name_of(const CalibrationRow& row) {
  return fmt::format("{}, dt = {:g} s, blocks of {:g} m", row.scheme, row.dt, row.block_length);
}

using RowValue = std::function<double(const CalibrationRow&)>;
using RowTest = std::function<bool(const CalibrationRow&)>;

// |value(row)| <= limit for every row that `counts`; a value that is not a number breaks it.
Promise at_most(const Calibration& calibration, std::string claim, double limit, const char* number_format,
                const RowTest& counts, const RowValue& value) {
  Promise promise{std::move(claim), "", {}};
  double worst = 0;
  for (const CalibrationRow& row : calibration.rows) {
    if (!counts(row)) continue;
    const double size = std::abs(value(row));
    worst = std::isnan(size) ? size : std::max(worst, size);
    if (!(size <= limit))
      promise.failures.push_back(fmt::format("{}: {} is {}", name_of(row), promise.claim,
                                             fmt::format(fmt::runtime(number_format), value(row))));
  }
  promise.measured = fmt::format(fmt::runtime(number_format), worst);
  return promise;
}

RowTest scheme_is(const std::string& name, double shortest = 0,
                  double longest = std::numeric_limits<double>::infinity()) {
  return [=](const CalibrationRow& row) {
    return row.scheme == name && row.block_length >= shortest && row.block_length <= longest;
  };
}

bool any(const CalibrationRow&) { return true; }

double amplitude_error(const CalibrationRow& row) { return row.amplitude_error_pct(); }
double velocity_error(const CalibrationRow& row) { return row.correlation_error_pct(); }

Promise oracle_study_promise(const Calibration& calibration) {
  Promise promise{"every law with every integrator against the closed form ≤ 1e-9 of the peak", "", {}};
  double worst = 0;
  for (const OracleResult& result : calibration.oracle) {
    worst = std::max(worst, result.max_rel_diff);
    if (!(result.max_rel_diff <= oracle_limit))
      promise.failures.push_back(fmt::format("{}, {}, blocks of {:g} m: difference from the closed form is {:.2e}",
                                             result.law, result.integrator, result.block_length, result.max_rel_diff));
  }
  promise.measured = fmt::format("{:.1e}", worst);
  return promise;
}

Promise cpu_promise(const Calibration& calibration) {
  const double accurate = calibration.total_cpu("accurate");
  const double thesis = calibration.total_cpu("thesis");
  Promise promise{"CPU time of all accurate rows ≤ that of all thesis rows",
                  fmt::format("{:.3f} s against {:.3f} s", accurate, thesis),
                  {}};
  if (!(accurate <= thesis)) promise.failures.push_back("all rows: " + promise.claim + " is " + promise.measured);
  return promise;
}

Promise counter_promise(const Calibration& calibration) {
  return at_most(calibration, "one factorization and one assembly of the matrix per row", 1, "{:.0f}", any,
                 [](const CalibrationRow& row) {
                   const bool once = row.factorizations == 1 && row.matrix_rebuilds == 1;
                   return once ? 1.0 : static_cast<double>(row.factorizations + row.matrix_rebuilds);
                 });
}

}  // namespace

std::vector<Promise> judge(const Calibration& calibration) {
  const auto most = [&](std::string claim, double limit, const char* format, const RowTest& counts,
                        const RowValue& value) {
    return at_most(calibration, std::move(claim), limit, format, counts, value);
  };
  return {
      most("thesis scheme: amplitude within 0.5 % of Table 3.2", thesis_limit_pct, "{:.3f} %", scheme_is("thesis"),
           [](const CalibrationRow& row) { return row.amplitude_vs_thesis_pct().value_or(std::nan("")); }),
      most("thesis scheme: velocity within 0.5 % of Table 3.3", thesis_limit_pct, "{:.3f} %", scheme_is("thesis"),
           [](const CalibrationRow& row) { return row.velocity_vs_thesis_pct().value_or(std::nan("")); }),
      most("every row: history within 1e-9 of the peak of the closed form", oracle_limit, "{:.1e}", any,
           [](const CalibrationRow& row) { return row.oracle_max_rel_diff; }),
      oracle_study_promise(calibration),
      most("accurate, blocks ≤ 1 m: first-peak amplitude error ≤ 0.2 %", 0.2, "{:.3f} %", scheme_is("accurate", 0, 1),
           amplitude_error),
      most("accurate, blocks ≤ 1 m: correlation velocity error ≤ 0.2 %", 0.2, "{:.3f} %", scheme_is("accurate", 0, 1),
           velocity_error),
      most("accurate, blocks of 2 m: first-peak amplitude error ≤ 1 %", 1, "{:.3f} %", scheme_is("accurate", 2, 2),
           amplitude_error),
      most("accurate, blocks of 2 m: correlation velocity error ≤ 0.7 %", 0.7, "{:.3f} %", scheme_is("accurate", 2, 2),
           velocity_error),
      most("accurate, blocks of 5 m: first-peak amplitude error ≤ 1 %", 1, "{:.3f} %", scheme_is("accurate", 5, 5),
           amplitude_error),
      most("accurate, blocks of 5 m: correlation velocity error ≤ 1 %", 1, "{:.3f} %", scheme_is("accurate", 5, 5),
           velocity_error),
      cpu_promise(calibration),
      most("every row: residual of the energy balance ≤ 1e-9 of its largest term", energy_limit, "{:.1e}", any,
           [](const CalibrationRow& row) { return row.energy_residual_rel; }),
      counter_promise(calibration),
  };
}

}  // namespace verify
