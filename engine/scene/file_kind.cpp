#include "engine/scene/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "engine/core/text_encoding.h"
#include "engine/drawing/read_drawing.h"

namespace dda {
namespace {

using namespace std::string_view_literals;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

constexpr auto no_command = "no command of this program reads it";
constexpr auto of_a_run = "dda view DIR shows the run in whose folder it is";

struct Mark {
  std::string_view first_bytes;
  const char* what;
  const char* command;
};

// What a file begins with.
constexpr std::array marks{
    Mark{"DDASTATE", "a checkpoint", "dda run SCENE.json --out DIR --resume goes on from the one in DIR"},
    Mark{"<VTKFile", "a frame or a list of frames", of_a_run},
    Mark{"time [s]", "a table of measurements", of_a_run},
    Mark{"AutoCAD Binary DXF", "a binary drawing (DXF)", "dda cut reads DXF that is saved as text"},
    Mark{"AC10", "a drawing (DWG)", "dda cut reads it when it is saved as DXF"},
    Mark{"\xD0\xCF\x11\xE0", "a workbook or document of an old kind",
         "dda cut reads workbooks that are saved as .xlsx"},
    Mark{"<!doctype html", "a web page", "browsers show it"},
    Mark{"<svg", "a picture", "browsers show it"},
    Mark{"<?xml", "an XML file", no_command},
    Mark{"%PDF", "a PDF document", no_command},
    Mark{"\x89PNG", "a picture", no_command},
    Mark{"\x1F\x8B", "a compressed file", "unpack it first"}};

std::string drawing_kind(const std::string& extension) {
  if (extension == ".csv") return "a table (CSV)";
  if (extension == ".xlsx") return "a workbook (XLSX)";
  if (extension == ".dc" || extension == ".geo") return "a drawing (lines of dc)";
  if (extension == ".blck" || extension == ".blk" || extension.empty()) return "a drawing (blocks of dc)";
  return fmt::format("a drawing ({})", extension == ".dxf" ? "DXF" : "GeoJSON");
}

// Files that nothing but their name tells from others: they hold numbers alone.
std::optional<FileKind> kind_by_name(const std::string& extension) {
  if (extension != ".df" && extension != ".ana") return std::nullopt;
  return FileKind{"data of a run for df",
                  "dda cut BLOCKS.blck --run-data FILE.df --out DIR reads it beside blocks or lines of dc"};
}

// Drawings are JSON in one of their formats.
bool begins_as_scene(std::string_view text, const std::string& extension) {
  return text.starts_with('{') && extension != ".geojson";
}

std::string_view without_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

}  // namespace

std::optional<FileKind> kind_other_than_scene(const std::filesystem::path& file, std::string_view beginning) {
  const std::string extension = lower_extension(file);
  const std::string_view text = without_blanks(beginning);
  if (text.empty() || begins_as_scene(text, extension)) return std::nullopt;
  if (is_utf16(text)) return FileKind{utf16_text, "save it as UTF-8"};
  for (const Mark& mark : marks)
    if (text.starts_with(mark.first_bytes)) return FileKind{mark.what, mark.command};
  const bool is_packed = text.starts_with("PK\x03\x04");
  if (is_packed && extension != ".xlsx") return FileKind{"a packed file (zip)", "dda cut reads workbooks (.xlsx)"};
  const bool is_dxf = text.starts_with("0\n") || text.starts_with("0\r\n") || text.starts_with("999");
  if (auto kind = kind_by_name(extension)) return kind;
  if (!is_drawing(file) && !(is_dxf && text.find("SECTION") != std::string_view::npos)) return std::nullopt;
  const std::string name = file.filename().string();
  return FileKind{drawing_kind(is_drawing(file) ? extension : ".dxf"),
                  fmt::format("dda cut {} --out DIR cuts it, and a scene takes it as the drawing of its rock", name)};
}

std::optional<FileKind> kind_other_than_scene(const std::filesystem::path& file) {
  std::array<char, 512> beginning{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return kind_other_than_scene(file, {beginning.data(), static_cast<std::size_t>(stream.gcount())});
}

}  // namespace dda
