// One asserted quantity with the case it belongs to and what that case cost: an entry of verification.json.
#pragma once

#include <string>
#include <vector>

#include "verification/suite/case.h"

namespace verify {

struct Row {
  std::string id;
  std::string title;
  std::vector<int> catalogue;
  Assertion assertion;
  bool passed = false;
  double cpu_s = 0;  // of the whole case, as are the counters
  dda::Counters counters;
};

// The row in one line: case, quantity, value, reference, error, tolerance, order and where they come from.
[[nodiscard]] std::string describe(const Row& row);

// All rows as {"cases": [...]}; numbers that are not finite are null.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows);

// Reads what to_json wrote; an order's tolerance, which the file does not hold, stays at its default. `file` is named
// by the dda::InputError that says what is wrong with the text.
[[nodiscard]] std::vector<Row> rows_from_json(const std::string& text, const std::string& file);

}  // namespace verify
