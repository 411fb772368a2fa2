// What all readers of the frames of a run say of files that are not as they should be.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/types.h"
#include "engine/record/vtp_reader.h"

namespace dda {

[[noreturn]] inline void refuse_frame(const std::filesystem::path& path, const std::string& value) {
  throw InputError(path.string(), "the file", value, "a frame that dda run --frames writes; run the scene again");
}

template <typename Number>
const std::vector<Number>& need_array(const std::filesystem::path& path, const std::vector<VtkArray>& arrays,
                                      std::string_view name, int components) {
  const auto* values = find_array<Number>(arrays, name, components);
  if (values == nullptr) refuse_frame(path, "without \"" + std::string(name) + "\"");
  return *values;
}

// The plane part of a vector, or of a point.
inline Vec2 plane(const std::vector<double>& values, std::size_t index) {
  return {values[3 * index], values[3 * index + 1]};
}

}  // namespace dda
