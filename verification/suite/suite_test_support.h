// Cases for the tests of this folder.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/suite/case.h"

namespace verify {

inline Assertion assertion_of(double value, double reference, double tolerance) {
  return {"slip", "m", value, reference, "g t^2/2", relative_error(value, reference), tolerance, "theory"};
}

inline Case case_of(const std::string& id, const std::vector<Assertion>& assertions, CaseLabel label = CaseLabel::fast,
                    std::vector<int> catalogue = {9}) {
  dda::Counters counters;
  counters.steps = 7;
  counters.contact_state_changes = 3;
  return {id, "Title of " + id, std::move(catalogue), label, [assertions, counters] {
            return Outcome{assertions, counters};
          }};
}

}  // namespace verify
