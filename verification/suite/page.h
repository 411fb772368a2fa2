// docs/verification.md: the whole page, put together from the tables of its cases and taken apart again.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/suite/case.h"
#include "verification/suite/page_table.h"

namespace verify {

using Tables = std::map<std::string, Lines>;  // of cases by their ids

// A summary by areas, the cases by catalogue number, each with its table if `tables` has it, and the problems that no
// case covers.
[[nodiscard]] std::string page_of(const std::vector<Case>& cases, const Tables& tables);

// The tables of a page; those of an empty text are none.
[[nodiscard]] Tables tables_of(const std::string& page);

// What of a page is not as `cases` and the tables `measured` have it: a sentence each. Tables of other cases are taken
// as they are.
[[nodiscard]] std::vector<std::string> differences(const std::string& page, const std::vector<Case>& cases,
                                                   const Tables& measured);

}  // namespace verify
