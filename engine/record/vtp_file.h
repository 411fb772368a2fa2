// ParaView's .vtp: VTK XML PolyData with its numbers appended raw (VTK file formats, "XML File Formats").
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dda {

struct VtkArray {
  std::string name;
  int components = 1;  // of each tuple
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>> values;
};

// Polygons in space. A cell is the polygon through points[connectivity[offsets[i - 1] .. offsets[i])].
struct PolyData {
  double time = 0;             // s, kept as field data "TimeValue"
  std::vector<double> points;  // m, three coordinates each
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;  // where each cell ends
  std::vector<VtkArray> point_data;
  std::vector<VtkArray> cell_data;
};

// Writes the file whole or not at all; std::runtime_error naming path and reason.
void write_vtp(const std::filesystem::path& path, const PolyData& data);

// `text` as it may stand between double quotes in XML.
std::string xml_escaped(std::string_view text);

}  // namespace dda
