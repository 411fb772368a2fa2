// `dda-verify run`: runs cases and writes verification.json.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "verification/study/command.h"
#include "verification/suite/case.h"
#include "verification/suite/runner.h"

namespace verify {

inline constexpr auto verification_file = "verification.json";

struct RunCommand {
  std::filesystem::path folder;  // gets verification.json; made if need be
  Selection selection;
};

// Runs the selected ones of `cases`: a line of progress each on `out`, every failed row on `errors`. Returns the exit
// code of the program: 0, or 1 if a row failed. Throws dda::InputError for what is not there, std::runtime_error if the
// file cannot be written.
int run_cases(const std::vector<Case>& cases, const RunCommand& command, std::ostream& out, std::ostream& errors);

// One line a case: catalogue numbers, label, id and title.
void list_cases(const std::vector<Case>& cases, std::ostream& out);

// `all_cases` is asked when the command is carried out.
using ListCases = const std::vector<Case>& (*)();
[[nodiscard]] StudyCommand run_command(const ListCases& all_cases);

// The options by which cases are selected.
void add_selection(Selection& selection, std::vector<CommandOption>& options);

}  // namespace verify
