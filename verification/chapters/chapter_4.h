// Chapter 4, the blast: its statements judged by the runs of the blast study.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "verification/chapters/statement.h"
#include "verification/thesis/blast_study.h"

namespace verify {

// What is in DIR/blast.json, or the study, run (80 s of CPU time) and kept there.
[[nodiscard]] BlastStudy chapter_4_study(const std::filesystem::path& folder);

[[nodiscard]] std::string blast_json(const BlastStudy& study);
// Throws dda::InputError if the text is not that of a study.
[[nodiscard]] BlastStudy blast_from_json(std::string_view text);

[[nodiscard]] Chapter chapter_4(const BlastStudy& study);

}  // namespace verify
