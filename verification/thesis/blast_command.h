// `dda-verify blast`: runs the study of chapter 4 and writes its page.
#pragma once

#include <filesystem>

namespace verify {

// Writes blast.md into the folder, which is made if need be. Throws std::runtime_error if a run fails or the file
// cannot be written.
void report_blast(const std::filesystem::path& folder);

}  // namespace verify
