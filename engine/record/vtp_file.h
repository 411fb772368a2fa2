// ParaView's .vtp: VTK XML PolyData with its numbers appended raw (VTK file formats, "XML File Formats").
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace dda {

struct VtkArray {
  std::string name;
  int components = 1;  // of each tuple
  // Texts have one component and hold no zero byte.
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<std::string>>
      values;
};

// One number of each item, as an array.
template <typename Number, typename Items, typename Value>
VtkArray numbers_of(std::string name, const Items& items, const Value& value) {
  std::vector<Number> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(static_cast<Number>(value(item)));
  return {std::move(name), 1, std::move(values)};
}

// Cell i goes through points[connectivity[offsets[i - 1] .. offsets[i])].
struct VtkCells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;  // where each cell ends

  [[nodiscard]] std::size_t size() const { return offsets.size(); }
  [[nodiscard]] std::span<const std::int64_t> cell(std::size_t i) const;
};

// Points, lines and polygons in space. Cell data are those of all vertices, then all lines, then all polygons.
struct PolyData {
  double time = 0;             // s, kept as field data "TimeValue"
  std::vector<double> points;  // m, three coordinates each
  VtkCells vertices;           // each of any number of points
  VtkCells lines;
  VtkCells polygons;
  std::vector<VtkArray> point_data;
  std::vector<VtkArray> cell_data;
};

// Writes the file whole or not at all; std::runtime_error naming path and reason.
void write_vtp(const std::filesystem::path& path, const PolyData& data);

// `text` as it may stand between double quotes in XML.
std::string xml_escaped(std::string_view text);

}  // namespace dda
