#include "engine/record/vtp_reader.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/xml_tags.h"

namespace dda {
namespace {

constexpr std::string_view data_mark = "<AppendedData encoding=\"raw\">\n_";

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& value) {
  throw InputError(path.string(), "the file", value, "what dda run --frames writes; run the scene again");
}

std::string text_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) refuse(path, "missing");
  return read_file(path);
}

// Nothing that a run writes is larger, and squares of such numbers are numbers too.
constexpr double largest = 1e150;

bool is_sane(double number) { return std::abs(number) <= largest; }  // false of what is no number

template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), text_(text_of(path)) {
    const std::size_t split = text_.find(data_mark);
    if (split == std::string::npos || !text_.starts_with("<VTKFile")) refuse(path_, "no .vtp file with raw data");
    data_ = std::string_view(text_).substr(split + data_mark.size());
    XmlTags tags(std::string_view(text_).substr(0, split));
    while (const auto tag = tags.next()) read(*tag);
  }

  PolyData check() && {
    if (result_.points.size() % 3 != 0) refuse(path_, "damaged (coordinates)");
    for (const VtkCells* cells : {&result_.vertices, &result_.lines, &result_.polygons}) check(*cells);
    check(result_.point_data, result_.points.size() / 3);
    check(result_.cell_data, result_.vertices.size() + result_.lines.size() + result_.polygons.size());
    return std::move(result_);
  }

 private:
  void read(const XmlTag& tag) {
    if (tag.name == "VTKFile" &&
        (tag.attribute("byte_order") == "LittleEndian") != (std::endian::native == std::endian::little))
      refuse(path_, "of a machine with another byte order");
    if (tag.name != "DataArray") {
      section_ = tag.name;
      return;
    }
    const VtkArray array = array_of(tag);
    if (section_ == "PointData") result_.point_data.push_back(array);
    if (section_ == "CellData") result_.cell_data.push_back(array);
    if (section_ == "Points") result_.points = values<double>(array);
    if (section_ == "FieldData" && array.name == "TimeValue") result_.time = time_of(array);
    if (section_ == "Verts") put(array, result_.vertices);
    if (section_ == "Lines") put(array, result_.lines);
    if (section_ == "Polys") put(array, result_.polygons);
  }

  VtkArray array_of(const XmlTag& tag) {
    const auto offset = number_of<std::size_t>(tag.attribute("offset"));
    const auto components = number_of<int>(tag.attribute("NumberOfComponents"));
    std::uint64_t size = 0;
    if (!offset || !components || *components < 1 || *offset > data_.size() || data_.size() - *offset < sizeof size)
      refuse(path_, "damaged or cut off");
    std::memcpy(&size, data_.data() + *offset, sizeof size);
    if (data_.size() - *offset - sizeof size < size) refuse(path_, "cut off");
    const std::string_view bytes = data_.substr(*offset + sizeof size, size);
    VtkArray array{tag.attribute("Name"), *components, {}};
    const std::string type = tag.attribute("type");
    if (type == "Float64")
      array.values = sane(numbers<double>(bytes), array.name);
    else if (type == "Int32")
      array.values = numbers<std::int32_t>(bytes);
    else if (type == "Int64")
      array.values = numbers<std::int64_t>(bytes);
    else if (type == "String")
      array.values = texts(array.name, bytes);
    else
      refuse(path_, "with numbers of type \"" + type + "\"");
    return array;
  }

  template <typename Number>
  static std::vector<Number> numbers(std::string_view bytes) {
    std::vector<Number> result(bytes.size() / sizeof(Number));
    if (!result.empty()) std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Number));
    return result;
  }

  [[nodiscard]] std::vector<double> sane(std::vector<double> numbers, const std::string& name) const {
    if (!std::ranges::all_of(numbers, is_sane)) refuse(path_, "damaged (" + name + " beyond all numbers)");
    return numbers;
  }

  [[nodiscard]] std::vector<std::string> texts(const std::string& name, std::string_view bytes) const {
    std::vector<std::string> result;
    for (std::size_t end = bytes.find('\0'); end != std::string_view::npos; end = bytes.find('\0')) {
      result.emplace_back(bytes.substr(0, end));
      bytes.remove_prefix(end + 1);
    }
    if (!bytes.empty()) refuse(path_, "damaged (" + name + ")");
    return result;
  }

  template <typename Number>
  std::vector<Number> values(const VtkArray& array) const {
    const auto* found = std::get_if<std::vector<Number>>(&array.values);
    if (found == nullptr) refuse(path_, "damaged (" + array.name + ")");
    return *found;
  }

  [[nodiscard]] double time_of(const VtkArray& array) const {
    const auto times = values<double>(array);
    if (times.size() != 1) refuse(path_, "damaged (TimeValue)");
    return times[0];
  }

  void put(const VtkArray& array, VtkCells& cells) const {
    if (array.name == "connectivity") cells.connectivity = values<std::int64_t>(array);
    if (array.name == "offsets") cells.offsets = values<std::int64_t>(array);
  }

  void check(const VtkCells& cells) const {
    const auto points = static_cast<std::int64_t>(result_.points.size() / 3);
    const bool in_order = std::is_sorted(cells.offsets.begin(), cells.offsets.end());
    const bool ends =
        cells.offsets.empty() ||
        (cells.offsets.front() >= 0 && static_cast<std::size_t>(cells.offsets.back()) == cells.connectivity.size());
    const bool in_range = std::ranges::all_of(cells.connectivity, [&](auto i) { return i >= 0 && i < points; });
    if (!in_order || !ends || !in_range) refuse(path_, "damaged (cells)");
  }

  void check(const std::vector<VtkArray>& arrays, std::size_t tuples) const {
    for (const VtkArray& array : arrays) {
      const std::size_t size = std::visit([](const auto& list) { return list.size(); }, array.values);
      if (size != tuples * static_cast<std::size_t>(array.components)) refuse(path_, "damaged (" + array.name + ")");
    }
  }

  const std::filesystem::path& path_;
  std::string text_;
  std::string_view data_;
  std::string section_;
  PolyData result_;
};

}  // namespace

std::vector<SeriesEntry> read_series(const std::filesystem::path& index) {
  const std::string text = text_of(index);
  if (!text.starts_with("<VTKFile") || text.find("</VTKFile>") == std::string::npos) refuse(index, "no list of frames");
  std::vector<SeriesEntry> entries;
  XmlTags tags(text);
  while (const auto tag = tags.next()) {
    if (tag->name != "DataSet") continue;
    const auto time = number_of<double>(tag->attribute("timestep"));
    if (!time || !is_sane(*time)) refuse(index, "damaged (timestep \"" + tag->attribute("timestep") + "\")");
    entries.push_back({*time, index.parent_path() / tag->attribute("file")});
  }
  return entries;
}

PolyData read_vtp(const std::filesystem::path& path) { return Reader(path).check(); }

}  // namespace dda
