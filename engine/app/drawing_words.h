// What options of the command line say of a drawing that is given in place of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/scene/drawn_scene.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace dda {

struct DrawingOptions {
  std::vector<std::string> layers;  // NAME=MEANING
  std::string unit;
  std::string run_data;  // file of df
};

void add_drawing_options(CLI::App& command, DrawingOptions& options);

// Throws InputError where they are given beside `file` that is a scene, or are not to be understood.
[[nodiscard]] DrawingWords words_of(const DrawingOptions& options, const std::filesystem::path& file);

}  // namespace dda
