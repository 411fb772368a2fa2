// Tables of the calibration report.
#pragma once

#include <vector>

#include "verification/study/document.h"
#include "verification/thesis/calibration.h"
#include "verification/thesis/promises.h"

namespace verify {

[[nodiscard]] Table amplitude_table(const Calibration& calibration);  // Table 3.2
[[nodiscard]] Table velocity_table(const Calibration& calibration);   // Table 3.3
[[nodiscard]] Table scheme_table();
[[nodiscard]] Table readings_table(const Calibration& calibration);        // definitions
[[nodiscard]] Table other_readings_table(const Calibration& calibration);  // what speaks for them
[[nodiscard]] Table schemes_error_table(const Calibration& calibration);
[[nodiscard]] Table oracle_table(const Calibration& calibration);
[[nodiscard]] Table counters_table(const Calibration& calibration);
[[nodiscard]] Table cpu_table(const Calibration& calibration);
[[nodiscard]] Table promises_table(const std::vector<Promise>& promises);

// Numbers with a true minus sign.
[[nodiscard]] std::string fixed(double value, int digits);
[[nodiscard]] std::string signed_pct(double value, int digits = 2);  // "+0.12"
[[nodiscard]] std::string scientific(double value);                  // "1.2·10⁻¹³"
[[nodiscard]] std::string milliseconds(double seconds);              // "0.01"

}  // namespace verify
