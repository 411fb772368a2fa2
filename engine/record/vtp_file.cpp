#include "engine/record/vtp_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <deque>
#include <iterator>
#include <span>

#include "engine/record/atomic_file.h"

namespace dda {
namespace {

std::string_view type_name(double) { return "Float64"; }
std::string_view type_name(std::int32_t) { return "Int32"; }
std::string_view type_name(std::int64_t) { return "Int64"; }

template <typename Number>
std::string_view bytes_of(std::span<const Number> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// VTK's array of texts: each ends with a zero byte.
std::string zero_ended(std::span<const std::string> texts) {
  std::string bytes;
  for (const std::string& text : texts) bytes.append(text).push_back('\0');
  return bytes;
}

// The XML text, and the arrays it refers to in the order in which they are appended.
class VtpText {
 public:
  template <typename Number>
  void array(std::string_view name, int components, std::span<const Number> values, std::string_view more = "") {
    append(type_name(Number{}), name, components, bytes_of(values), more);
  }

  void array(std::string_view name, int components, std::span<const std::string> texts) {
    append("String", name, components, texts_.emplace_back(zero_ended(texts)));
  }

  void array(const VtkArray& array) {
    std::visit([&](const auto& values) { this->array(array.name, array.components, std::span(values)); }, array.values);
  }

  void open(std::string_view tag, std::string_view attributes = "") {
    line(fmt::format("<{}{}>", tag, attributes));
    ++depth_;
  }

  void close(std::string_view tag) {
    --depth_;
    line(fmt::format("</{}>", tag));
  }

  void write(const std::filesystem::path& path) const {
    AtomicFile file(path);
    file.write(text_ + "<AppendedData encoding=\"raw\">\n_");
    for (const std::string_view bytes : appended_) {
      const std::uint64_t size = bytes.size();
      file.write(bytes_of(std::span(&size, 1)));
      file.write(bytes);
    }
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
  }

 private:
  void append(std::string_view type, std::string_view name, int components, std::string_view bytes,
              std::string_view more = "") {
    line(fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"{}/>)",
                     type, xml_escaped(name), components, offset_, more));
    appended_.push_back(bytes);
    offset_ += sizeof(std::uint64_t) + bytes.size();
  }

  void line(std::string_view content) {
    fmt::format_to(std::back_inserter(text_), "{:{}}{}\n", "", 2 * depth_, content);
  }

  std::string text_;
  std::deque<std::string> texts_;  // what of `appended_` is nobody else's; stays where it is as it grows
  std::vector<std::string_view> appended_;
  std::size_t offset_ = 0;
  int depth_ = 0;
};

void add_section(VtpText& text, std::string_view tag, const std::vector<VtkArray>& arrays) {
  text.open(tag);
  for (const VtkArray& array : arrays) text.array(array);
  text.close(tag);
}

void add_cells(VtpText& text, std::string_view tag, const VtkCells& cells) {
  text.open(tag);
  text.array("connectivity", 1, std::span(cells.connectivity));
  text.array("offsets", 1, std::span(cells.offsets));
  text.close(tag);
}

void add_piece(VtpText& text, const PolyData& data) {
  text.open("Piece",
            fmt::format(R"( NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="{}" NumberOfStrips="0" )"
                        R"(NumberOfPolys="{}")",
                        data.points.size() / 3, data.vertices.size(), data.lines.size(), data.polygons.size()));
  add_section(text, "PointData", data.point_data);
  add_section(text, "CellData", data.cell_data);
  text.open("Points");
  text.array("Points", 3, std::span(data.points));
  text.close("Points");
  add_cells(text, "Verts", data.vertices);
  add_cells(text, "Lines", data.lines);
  add_cells(text, "Polys", data.polygons);
  text.close("Piece");
}

}  // namespace

std::span<const std::int64_t> VtkCells::cell(std::size_t i) const {
  const auto first = static_cast<std::size_t>(i == 0 ? 0 : offsets[i - 1]);
  return std::span(connectivity).subspan(first, static_cast<std::size_t>(offsets[i]) - first);
}

void write_vtp(const std::filesystem::path& path, const PolyData& data) {
  constexpr bool little = std::endian::native == std::endian::little;
  VtpText text;
  text.open("VTKFile", fmt::format(R"( type="PolyData" version="1.0" byte_order="{}" header_type="UInt64")",
                                   little ? "LittleEndian" : "BigEndian"));
  text.open("PolyData");
  text.open("FieldData");
  text.array("TimeValue", 1, std::span(&data.time, 1), R"( NumberOfTuples="1")");
  text.close("FieldData");
  add_piece(text, data);
  text.close("PolyData");
  text.write(path);
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

}  // namespace dda
