// `dda spectrum`: the response spectrum of a measured motion.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace dda {

// As the command line has it.
struct SpectrumRequest {
  std::filesystem::path folder;
  std::string measurement;
  std::vector<std::string> damping = {"0.05"};  // shares of critical damping
  std::vector<std::string> periods;             // the shortest and the longest, or none
  std::string count = "100";                    // of periods
  std::filesystem::path file;                   // empty: spectrum.csv in the folder
};

// The command with its options and help; parsing fills `request`.
void add_spectrum(CLI::App& app, SpectrumRequest& request);

// Says on `out` what was written, and which periods the measurement does not resolve. Throws InputError for what is
// wrong with folder or options, before anything is written.
void write_spectrum(const SpectrumRequest& request, std::ostream& out);

}  // namespace dda
