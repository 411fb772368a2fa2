// The calibration report as a Document; figures are named relative to the report's folder.
#pragma once

#include <string>
#include <vector>

#include "verification/study/document.h"
#include "verification/thesis/calibration.h"
#include "verification/thesis/promises.h"

namespace verify {

inline constexpr auto plots_folder = "plots";

struct ReportFacts {
  bool figures = true;       // they were drawn
  double total_cpu_s = 0;    // of the whole study
  std::string command_line;  // to repeat it
};

[[nodiscard]] Document calibration_report(const Calibration& calibration, const std::vector<Promise>& promises,
                                          const ReportFacts& facts);

}  // namespace verify
