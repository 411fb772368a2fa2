// `dda-verify table`: docs/verification.md from what `dda-verify run` measured.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "verification/study/command.h"
#include "verification/suite/case.h"
#include "verification/suite/run_command.h"
#include "verification/suite/runner.h"

namespace verify {

struct TableCommand {
  std::filesystem::path results;  // a folder with verification.json, or with ID/verification.json for every case
  std::filesystem::path page;
  Selection selection;  // of the results
  bool check = false;   // compare, write nothing
};

// Writes the page: tables of the selected cases from the results, those of cases that are not there as the page has
// them. Or checks that the page says what every selected case measured. Returns the exit code of the program: 0, or 1
// if the page is stale or a row has failed, told on `errors`. Throws dda::InputError for what is not there.
int make_table(const std::vector<Case>& cases, const TableCommand& command, std::ostream& out, std::ostream& errors);

[[nodiscard]] StudyCommand table_command(const ListCases& all_cases);

}  // namespace verify
