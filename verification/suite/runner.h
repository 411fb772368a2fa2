// Runs cases and judges what they assert.
#pragma once

#include <string>
#include <vector>

#include "verification/suite/case.h"
#include "verification/suite/row.h"

namespace verify {

// One row per assertion, judged by passed(), with the CPU time of the case on the calling thread. A case that throws or
// asserts nothing gives one failed row whose quantity is "completed" and whose source says why.
[[nodiscard]] std::vector<Row> run_case(const Case& given);

[[nodiscard]] std::string name_of(CaseLabel label);

// Which cases to run; an empty list asks for nothing and leaves all in.
struct Selection {
  std::vector<std::string> ids;
  std::vector<std::string> labels;
};

// The cases of one of the ids and one of the labels, in the order of `cases`. Throws dda::InputError for an id or label
// that is not there, with the nearest that is, and if none of the ids has one of the labels.
[[nodiscard]] std::vector<Case> select(const std::vector<Case>& cases, const Selection& selection);

}  // namespace verify
