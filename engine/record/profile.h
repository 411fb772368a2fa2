// Where the time of a run went, as a table for people and as a file for trace viewers.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/counters.h"
#include "engine/core/phase_clock.h"

namespace dda {

// Phases with calls, seconds and share, the longest first, and counters. Phases that never were are left out.
std::string profile_table(const PhaseClock& clock, const Counters& counters);

// The same as JSON, with the calls as complete events of the Trace Event Format, which chrome://tracing and
// ui.perfetto.dev show. Errors as of write_file.
void write_profile(const std::filesystem::path& path, const PhaseClock& clock, const Counters& counters);

}  // namespace dda
