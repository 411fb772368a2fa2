// peaks.csv: the strongest motion of every block, and what summary.json says of it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "engine/model/block_peaks.h"

namespace dda {

// A row for each block that takes part; times are those of the run. Columns that the scene does not ask for are left
// out; ejected_at is empty for blocks that are not ejected.
std::string peaks_csv(const Model& model, std::span<const BlockPeaks> peaks);

// The entry "peaks" of the summary. `is_over`: the stage has come to its end.
nlohmann::ordered_json peaks_json(const Model& model, std::span<const BlockPeaks> peaks, bool is_over);

}  // namespace dda
