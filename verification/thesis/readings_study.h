// Which reading of "amplitude", "velocity" and "50 m" the thesis must have used: those that fit its print, and those
// that do not.
#pragma once

#include <string>
#include <vector>

#include "verification/thesis/reference.h"

namespace verify {

struct ReadingResult {
  std::string place;
  std::string amplitude;  // how it is read
  std::string velocity;
  double amplitude_pct = 0;  // largest difference from Table 3.2 over all its rows, in % of the printed number
  double velocity_pct = 0;   // the same for Table 3.3
};

// The scheme "thesis", its histories read in several ways; the first is the one chosen.
[[nodiscard]] std::vector<ReadingResult> readings_study(const ThesisReference& reference,
                                                        const std::vector<double>& time_steps, double duration);

}  // namespace verify
