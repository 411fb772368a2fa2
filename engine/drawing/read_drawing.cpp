#include "engine/drawing/read_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/text_encoding.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

using Reader = LineDrawing (*)(std::string_view, const std::string&, double);

struct Format {
  std::string_view extension;
  Reader read;
  bool capitals_count = false;  // whether they tell layers apart
};
// Without a length of its own: one more than there are formats would be a format of files without an extension.
constexpr auto formats = std::to_array<Format>({{".dxf", read_dxf},
                                                {".csv", read_csv_drawing},
                                                {".xlsx", read_xlsx},
                                                {".geojson", read_geojson, true},
                                                {".dc", read_dc},
                                                {".geo", read_dc},
                                                {".blck", read_blck},
                                                {".blk", read_blck}});

// dc gives its blocks a name without an extension.
const Format* format_of(const std::filesystem::path& file) {
  const bool is_of_dc = in_lower_case(file.filename().string()) == "blck";
  const std::string extension = is_of_dc ? ".blck" : in_lower_case(file.extension().string());
  const auto found = std::ranges::find(formats, std::string_view(extension), &Format::extension);
  return found == formats.end() ? nullptr : found;
}

}  // namespace

bool is_drawing(const std::filesystem::path& file) { return format_of(file) != nullptr; }

bool is_of_dc(const std::filesystem::path& file) {
  const Format* format = format_of(file);
  return format != nullptr && (format->read == read_dc || format->read == read_blck);
}

std::string drawing_extensions() {
  std::string list;
  for (const Format& format : formats) {
    const bool is_last = &format == &formats.back();
    list += fmt::format("{}{}", list.empty() ? "" : is_last ? " or " : ", ", format.extension);
  }
  return list;
}

LineDrawing read_drawing(const std::filesystem::path& file, const std::string& name, double metres) {
  const Format* format = format_of(file);
  if (format == nullptr)
    throw InputError("", "the drawing", "\"" + readable(name) + "\"", "a " + drawing_extensions() + " file");
  std::string text;
  try {
    text = read_file(file, most_input_bytes);
  } catch (const UnreadableFile& error) {
    throw InputError("", readable(name), error.why(), "a drawing");
  }
  if (is_utf16(text)) throw InputError("", readable(name), utf16_text, save_as_utf8);
  LineDrawing drawing = format->read(text, readable(name), metres);
  if (drawing.lines.empty()) throw InputError("", drawing.name, "without lines", "a boundary and joints");
  if (!format->capitals_count) take_spellings_as_one(drawing);
  return drawing;
}

}  // namespace dda
