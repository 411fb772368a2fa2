// What a run was asked for: program, options and scene, kept beside its results as run.json. A run goes on (--resume)
// only with the same request, because only then are its results those of one run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/app/run_options.h"

namespace dda {

// `scene_text`: the text of options.scene, which is a scene that could be read; `stages_done`: how many of its stages
// were done by the run that it goes on from.
nlohmann::json run_request(const RunOptions& options, std::string_view scene_text, std::size_t stages_done);

// Reads that number from the request of the run in `folder`, which is to be resumed.
std::size_t stages_before(const std::filesystem::path& folder);

// Writes the request to its file in `folder`, which must exist. Throws std::runtime_error naming path and reason.
void write_request(const std::filesystem::path& folder, const nlohmann::json& request);

// The name and version of this program, as a request has it.
std::string this_program();

// Reads the request of a run. Throws InputError naming its file, and what is `expected`, where `folder` has none.
nlohmann::json read_request(const std::filesystem::path& folder, const std::string& expected);

// Throws InputError naming the first option, or field of the scene, that differs from what the run in `folder` was
// begun with, and both values; also when that is not known.
void expect_same_request(const RunOptions& options, const nlohmann::json& request);

}  // namespace dda
