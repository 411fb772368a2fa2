// Small scenes of the public format with features mixed by lot: the same seed gives the same scene everywhere.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

namespace verify {

// Not every mixture is allowed: about one in ten scenes is refused when it is read.
[[nodiscard]] nlohmann::ordered_json random_scene(std::uint64_t seed);

}  // namespace verify
