// Files that a command is told to write.
#pragma once

#include <filesystem>

namespace dda {

// Refuses `--out file` where nothing can be written: no folder for it, or a folder, link or device of that name.
void expect_output(const std::filesystem::path& file);

}  // namespace dda
