// The page of `dda report` (HTML): status, scene, energies, measurements, the last picture, warnings, counters, times.
#pragma once

#include <filesystem>
#include <string>

namespace dda {

// Returns the page of the run in `folder`, from its files alone. Throws InputError naming the file when there is no run
// that has ended, or a file is broken.
std::string report_page(const std::filesystem::path& folder);

}  // namespace dda
