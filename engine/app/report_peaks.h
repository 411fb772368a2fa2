// What the page of `dda report` says of the strongest motion of the blocks.
#pragma once

#include <filesystem>
#include <string>

#include "engine/app/report_tables.h"

namespace dda {

// Peak values, ejected blocks by velocity, and peak velocities over distances with their fit; nothing where the scene
// asked for none. InputError naming peaks.csv where it is broken.
std::string peaks_part(const Json& summary, const std::filesystem::path& folder);

}  // namespace dda
