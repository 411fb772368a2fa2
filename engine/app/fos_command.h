// `dda fos`: by how much the strength of the joints exceeds what the rock needs to stand, and what moves when it does
// not.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace dda {

// As the command line has it.
struct FosRequest {
  std::filesystem::path scene;
  std::filesystem::path folder;  // for fos.json and fos.svg; empty: none are written
  double most = 64;              // the factor is looked for between 1/most and this
  double width = 0.005;          // of the interval in which it lies, as a share of the factor
  std::optional<int> jobs;       // runs at once; none: as many as there are cores
};

// The command with its options and help; parsing fills `request`.
void add_fos(CLI::App& app, FosRequest& request);

// Says on `out` what was found, and on `progress` what is under way. Throws InputError for what is wrong with scene or
// options, before anything is written.
void find_factor_of_safety(const FosRequest& request, std::ostream& out, std::ostream& progress);

}  // namespace dda
