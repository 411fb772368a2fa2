#include "engine/app/drawing_words.h"

#include <CLI/CLI.hpp>

#include "engine/core/error.h"
#include "engine/drawing/read_drawing.h"

namespace dda {

void add_drawing_options(CLI::App& command, DrawingOptions& options) {
  command.add_option("--layer", options.layers, "what a layer of a drawing is, e.g. \"bed joints=rock\"; any number")
      ->type_name("NAME=MEANING")
      ->allow_extra_args(false);
  command.add_option("--unit", options.unit, "of a drawing's coordinates, e.g. mm; default what it says, else m")
      ->type_name("UNIT");
}

DrawingWords words_of(const DrawingOptions& options, const std::filesystem::path& file) {
  const bool said = !options.layers.empty() || !options.unit.empty();
  if (said && !is_drawing(file))
    throw InputError("", options.layers.empty() ? "--unit" : "--layer", "given beside a scene",
                     "a drawing; a scene says it in \"drawing\"");
  DrawingWords words;
  words.unit = options.unit;
  for (const std::string& layer : options.layers) {
    const auto at = layer.rfind('=');
    if (at == std::string::npos || at == 0) throw InputError("", "--layer", "\"" + layer + "\"", "NAME=MEANING");
    words.layers[layer.substr(0, at)] = layer.substr(at + 1);
  }
  return words;
}

}  // namespace dda
