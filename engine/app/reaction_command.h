// `dda reaction`: the ground reaction curve of an opening, by which its support is chosen.
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
struct ReactionRequest {
  std::filesystem::path scene;
  std::string opening;           // name of an opening of the rock or of a group of blocks
  std::filesystem::path folder;  // for reaction.json, reaction.csv and reaction.svg; empty: none are written
  int steps = 10;                // equal ones from a share of 1 to 0
  std::string shares;            // in place of these, numbers between commas; or empty
};

// The command with its options and help; parsing fills `request`.
void add_reaction(CLI::App& app, ReactionRequest& request);

// Says on `out` what was found, and on `progress` what is under way. Returns the exit code: 0; 3 when the rock did not
// settle in situ (the reason is on `progress`), and nothing is written then. Throws InputError for what is wrong with
// scene or options, before anything is written.
int find_ground_reaction(const ReactionRequest& request, std::ostream& out, std::ostream& progress);

}  // namespace dda
