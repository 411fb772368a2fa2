// What the calibration promises, and whether this run kept it.
#pragma once

#include <string>
#include <vector>

#include "verification/thesis/calibration.h"

namespace verify {

struct Promise {
  std::string claim;
  std::string measured;               // the worst case
  std::vector<std::string> failures;  // one sentence per row that breaks it

  [[nodiscard]] bool kept() const { return failures.empty(); }
};

[[nodiscard]] std::vector<Promise> judge(const Calibration& calibration);

}  // namespace verify
