// Runs of other programs, put into the folder by a script of ci/, for the same table.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "verification/precision/study.h"

namespace verify {

inline constexpr std::string_view other_systems_file = "other_systems.csv";

// Columns problem, law (the program), integrator, size_m, dt_s, cells, steps, error, reading_error, cpu_s, under a head
// line; nothing if there is no such file. Throws std::runtime_error for a line that is not so.
[[nodiscard]] std::vector<Measured> read_other_systems(const std::filesystem::path& file);

}  // namespace verify
