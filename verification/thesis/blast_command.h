// `dda-verify blast`: runs the study of chapter 4 and writes its page.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "verification/study/command.h"

namespace verify {

// Writes blast.md into the folder, which is made if need be. Throws std::runtime_error if a run fails or the file
// cannot be written.
void report_blast(const std::filesystem::path& folder);

// Runs the study and compares it with the page, which is not changed; each line that is not so any more is told. Exit
// code: 0, or 1 for a page that is stale or missing.
[[nodiscard]] int check_blast_page(const std::filesystem::path& page, std::ostream& errors);

[[nodiscard]] StudyCommand blast_command();

}  // namespace verify
