#include "engine/app/drawing_words.h"

#include <CLI/CLI.hpp>

#include "engine/core/error.h"
#include "engine/drawing/read_drawing.h"

namespace dda {

namespace {

// The first of the options that is given.
const char* option_given(const DrawingOptions& options) {
  if (!options.layers.empty()) return "--layer";
  if (!options.unit.empty()) return "--unit";
  return options.run_data.empty() ? nullptr : "--run-data";
}

// Materials and joints have numbers in what dc reads and writes; other drawings have none.
void check_run_data(const DrawingOptions& options, const std::filesystem::path& file) {
  if (options.run_data.empty()) return;
  if (!is_of_dc(file))
    throw InputError("", "--run-data", "given beside " + file.string(), "blocks or lines of dc (.blck, .dc)");
  if (!options.unit.empty())
    throw InputError("", "--unit", "given beside --run-data", "one of the two: run data are in the units of the file");
}

}  // namespace

void add_drawing_options(CLI::App& command, DrawingOptions& options) {
  command.add_option("--layer", options.layers, "what a layer of a drawing is, e.g. \"bed joints=rock\"; any number")
      ->type_name("NAME=MEANING")
      ->allow_extra_args(false);
  command.add_option("--unit", options.unit, "of a drawing's coordinates, e.g. mm; default what it says, else m")
      ->type_name("UNIT");
  command
      .add_option("--run-data", options.run_data,
                  "beside blocks or lines of dc: materials, joints, loads and steps as df has them")
      ->type_name("FILE.df");
}

DrawingWords words_of(const DrawingOptions& options, const std::filesystem::path& file) {
  const char* const said = option_given(options);
  if (said != nullptr && !is_drawing(file))
    throw InputError("", said, "given beside a scene", "a drawing; a scene says it in \"drawing\"");
  check_run_data(options, file);
  DrawingWords words;
  words.unit = options.unit;
  words.run_data = options.run_data;
  for (const std::string& layer : options.layers) {
    const auto at = layer.rfind('=');
    if (at == std::string::npos || at == 0) throw InputError("", "--layer", "\"" + layer + "\"", "NAME=MEANING");
    words.layers[layer.substr(0, at)] = layer.substr(at + 1);
  }
  return words;
}

}  // namespace dda
