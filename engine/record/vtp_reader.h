// Reads back what vtp_file.h and vtp_series.h write, and nothing else: this is no reader of VTK files in general.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/record/vtp_file.h"

namespace dda {

struct SeriesEntry {
  double time = 0;             // s
  std::filesystem::path file;  // where it is
};

// The files that an index DIR/NAME.pvd lists, in its order. InputError naming the file for an index that is missing or
// broken.
std::vector<SeriesEntry> read_series(const std::filesystem::path& index);

// InputError naming the file and what is wrong with it: missing, cut off, not written by write_vtp. Cells then refer to
// points that are there, and every array has a tuple for each of its points or cells.
PolyData read_vtp(const std::filesystem::path& path);

// The values of the array of this name and number of components; nothing when there is none.
template <typename Number>
const std::vector<Number>* find_array(const std::vector<VtkArray>& arrays, std::string_view name, int components) {
  for (const VtkArray& array : arrays)
    if (array.name == name && array.components == components) return std::get_if<std::vector<Number>>(&array.values);
  return nullptr;
}

}  // namespace dda
