// Where `dda run --from DIR[:STAGE]` begins: the end of a stage of the run in DIR, the last one where none is named.
#pragma once

#include <filesystem>
#include <string>

#include "engine/simulation/simulation.h"

namespace dda {

struct BranchOrigin {
  std::filesystem::path folder;
  std::string stage;  // empty: the last
};

// "DIR" or "DIR:STAGE"; a folder whose own name has a colon is meant as a whole. InputError where there is no such
// folder.
BranchOrigin parse_origin(const std::string& from);

// The run in that folder as it was between that stage and the next. Files that its scene names are looked for in
// `files`. InputError when the folder has no run of this version, the run has no such stage, or has not come to its
// end.
Simulation load_origin(const BranchOrigin& origin, const std::filesystem::path& files);

}  // namespace dda
