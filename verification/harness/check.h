// A measure of a run and the most it may be, for populations and charts whose runs are judged by several.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace verify {

// Holds unless `value` is more than `allowed`, or no number.
struct Check {
  std::string what;
  double value = 0;
  double allowed = 0;

  [[nodiscard]] bool holds() const { return value <= allowed; }
};

// A value that is no number, or has no end, is written as null.
[[nodiscard]] nlohmann::ordered_json json_of(const Check& check);

// What the first that does not hold says; empty where all hold.
[[nodiscard]] std::string first_failure(const std::vector<Check>& checks);

}  // namespace verify
