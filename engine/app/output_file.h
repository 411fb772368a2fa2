// Files that a command is told to write.
#pragma once

#include <filesystem>

namespace dda {

// Refuses `--out file` where nothing can be written: no folder for it, or none that files can be made in, or a folder,
// link or device of that name. That the folder of the run is missing, in which files lie unless they are named, is left
// to who reads the run.
void expect_output(const std::filesystem::path& file, const std::filesystem::path& folder_of_run);

}  // namespace dda
