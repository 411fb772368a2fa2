// The page that shows a run: one HTML file that needs nothing else.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>

namespace dda {

struct PageOptions {
  std::filesystem::path folder;          // what dda run wrote to
  std::filesystem::path file;            // the page
  std::string quantity = "mean_stress";  // blocks are coloured by at first
  std::size_t most_bytes = 50'000'000;   // of frames in the page
};

// Writes the page and says on `out` what is in it. Of a run that would make it larger than asked for, only every
// second, third, ... frame is taken, and the last. InputError for a folder without frames, broken files, an unknown
// quantity, or blocks too many for two frames; std::runtime_error when the page cannot be written.
void write_page(const PageOptions& options, std::ostream& out);

}  // namespace dda
