// `dda keyblocks`: which blocks around an opening or at a slope can come out, and what holds them.
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
struct KeyBlocksRequest {
  std::filesystem::path scene;
  std::string opening;               // name of an opening of the rock or of a group of blocks; empty: all free faces
  std::filesystem::path folder;      // for keyblocks.json and keyblocks.svg; empty: none are written
  double wanted_safety = 1.5;        // factor of safety that bolts are to give
  std::string bolt_direction;        // an angle with its unit; empty: square into the free faces
  std::vector<double> acceleration;  // m/s2, x and y, besides gravity; or empty
};

// The command with its options and help; parsing fills `request`.
void add_keyblocks(CLI::App& app, KeyBlocksRequest& request);

// Says on `out` what was found. Throws InputError for what is wrong with scene or options, before anything is written.
void find_key_blocks(const KeyBlocksRequest& request, std::ostream& out);

}  // namespace dda
