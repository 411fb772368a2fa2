// For the tests of this folder.
#pragma once

namespace verify {

// Two jobs of some milliseconds, and one that cannot be measured.
inline constexpr auto three_jobs =
    R"({"grid": {"block_length": ["10 m"], "dt": ["0.2 ms", "0.3 ms", "4 ms"], "law": ["consistent"]}})";

}  // namespace verify
