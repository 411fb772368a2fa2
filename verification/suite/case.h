// One problem of the verification catalogue: what it runs, and what it asserts of the result.
//
// A case returns one Assertion per asserted quantity; it never judges by itself. `dda-verify run` and ctest both run
// the list of verification/cases/all_cases.h and judge by passed().
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/counters.h"

namespace verify {

// An observed order of convergence, held from both sides on the finest levels.
struct Order {
  double observed = 0;
  double expected = 0;
  double tolerance = 0.1;
};

// One asserted quantity: a row of verification.json.
struct Assertion {
  std::string quantity;  // "slip after 2 s, friction 20 deg"
  std::string unit;
  double value = 0;
  double reference = 0;
  std::string source;  // formula with book or paper and equation, or what of verification/exact computes it
  double error = 0;    // relative to the reference, unless `quantity` says otherwise
  double tolerance = 0;
  std::string tolerance_reason;  // theory, source, or measured with margin
  std::optional<Order> order = {};
};

struct Outcome {
  std::vector<Assertion> assertions;
  dda::Counters counters;  // of all runs of the case together
};

enum class CaseLabel { fast, slow };  // fast: below about a second of CPU time

struct Case {
  std::string id;  // "incline-sliding": lower case, digits and dashes
  std::string title;
  std::vector<int> catalogue;  // numbers in the verification catalogue
  CaseLabel label = CaseLabel::fast;
  std::function<Outcome()> run;  // throws when the engine ends with anything but Status::ok
};

// NaN never passes.
inline bool passed(const Assertion& assertion) {
  if (!(std::abs(assertion.error) <= assertion.tolerance)) return false;
  if (!assertion.order) return true;
  return std::abs(assertion.order->observed - assertion.order->expected) <= assertion.order->tolerance;
}

inline double relative_error(double value, double reference) { return value / reference - 1; }

}  // namespace verify
