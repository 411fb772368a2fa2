// The formats of drawings. Each reader takes the text of a file, its name for messages, and how many metres a unit of
// its coordinates is: 0 for what the file says, and metres where it says nothing. Throws InputError, without a file,
// whose field begins with the name.
#pragma once

#include <string_view>

#include "engine/drawing/line_drawing.h"

namespace dda {

LineDrawing read_dxf(std::string_view text, const std::string& name, double metres);
LineDrawing read_csv_drawing(std::string_view text, const std::string& name, double metres);
LineDrawing read_xlsx(std::string_view text, const std::string& name, double metres);
LineDrawing read_geojson(std::string_view text, const std::string& name, double metres);

// The lines that dl writes and dc cuts in the original DDA.
LineDrawing read_dc(std::string_view text, const std::string& name, double metres);

// The blocks that dc writes and df reads.
LineDrawing read_blck(std::string_view text, const std::string& name, double metres);

}  // namespace dda
