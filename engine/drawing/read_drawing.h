// Drawings from files.
#pragma once

#include <filesystem>
#include <string>

#include "engine/drawing/line_drawing.h"

namespace dda {

// Whether the name of the file says that it holds a drawing: .dxf, .csv, .xlsx, .geojson, .dc, .geo, .blck, .blk,
// or is blck.
bool is_drawing(const std::filesystem::path& file);

// Whether it says that dc of the original DDA reads or writes it: its joints and materials have numbers.
bool is_of_dc(const std::filesystem::path& file);

// ".dxf, .csv, .xlsx, .geojson, .dc, .geo, .blck or .blk".
std::string drawing_extensions();

// Reads a drawing in the format its name says. `name` stands for it in messages; `metres` is a unit of its coordinates,
// 0 for what the file says. Throws InputError, without a file, whose field begins with the name.
LineDrawing read_drawing(const std::filesystem::path& file, const std::string& name, double metres = 0);

}  // namespace dda
