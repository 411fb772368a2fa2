// What dda run said of a run besides its frames: summary.json and histories.csv, as far as they are there.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "engine/view/histories.h"

namespace dda {

struct RunFacts {
  std::string title;               // of the scene, or the name of the folder
  nlohmann::ordered_json summary;  // null while the run goes on
  std::optional<Histories> histories;
};

// Both throw InputError naming the file for one that is broken.
nlohmann::ordered_json read_summary(const std::filesystem::path& file);
RunFacts read_facts(const std::filesystem::path& folder);

}  // namespace dda
