// Tables in a spreadsheet (ECMA-376, Office Open XML): an archive of XML files. xl/workbook.xml names the sheets, and
// its relations say which file each is; texts are shared between the cells of all sheets.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layer_table.h"
#include "engine/drawing/number_text.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/zip_archive.h"

namespace dda {
namespace {

constexpr std::size_t most_columns = 16384;  // of a sheet

// Takes off a name the prefix of its namespace, which programs choose as they like.
std::string_view local(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

template <typename Visit>
void for_each_child(const pugi::xml_node& node, std::string_view name, Visit visit) {
  for (const pugi::xml_node& child : node.children()) {
    if (local(child.name()) == name) visit(child);
  }
}

pugi::xml_node first_child(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node& child : node.children()) {
    if (local(child.name()) == name) return child;
  }
  return {};
}

std::string attribute(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& each : node.attributes()) {
    if (local(each.name()) == name) return each.value();
  }
  return {};
}

// Reads a shared or inline text, which is a plain one, or runs with formats of their own.
std::string text_in(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& child : node.children()) {
    if (local(child.name()) == "t") text += child.text().get();
    if (local(child.name()) == "r") text += first_child(child, "t").text().get();
  }
  return text;
}

// "BC12" is 54; nothing where there are no letters, or more than a sheet has columns.
std::optional<std::size_t> column_in(std::string_view reference) {
  std::size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + static_cast<std::size_t>(c - 'A' + 1);
    if (column > most_columns) return std::nullopt;
  }
  return column == 0 ? std::nullopt : std::optional(column - 1);
}

struct Sheet {
  std::string name;
  std::string path;  // in the archive
};

class XlsxReader {
 public:
  XlsxReader(std::string_view text, const std::string& name, double metres) : archive_(text, name), metres_(metres) {
    drawing_.name = name;
  }

  LineDrawing read() {
    read_shared_texts();
    for (const Sheet& sheet : sheets()) read_sheet(sheet);
    if (tables_ == 0)
      throw InputError("", drawing_.name, "without a table", std::string("a sheet with ") + table_header);
    return std::move(drawing_);
  }

 private:
  [[nodiscard]] bool load(const std::string& path, pugi::xml_document& document) const {
    const auto text = archive_.file(path);
    if (!text) return false;
    if (!document.load_buffer(text->data(), text->size()))
      throw InputError("", drawing_.name, "a spreadsheet whose " + path + " is no XML", "an .xlsx file");
    return true;
  }

  void read_shared_texts() {
    pugi::xml_document document;
    if (!load("xl/sharedStrings.xml", document)) return;
    for_each_child(document.document_element(), "si",
                   [&](const pugi::xml_node& node) { texts_.push_back(text_in(node)); });
  }

  [[nodiscard]] std::vector<Sheet> sheets() const {
    pugi::xml_document book;
    pugi::xml_document relations;
    if (!load("xl/workbook.xml", book) || !load("xl/_rels/workbook.xml.rels", relations))
      throw InputError("", drawing_.name, "an archive without a workbook", "an .xlsx file");
    std::map<std::string, std::string> targets;
    for_each_child(relations.document_element(), "Relationship", [&](const pugi::xml_node& node) {
      const std::string target = attribute(node, "Target");
      targets[attribute(node, "Id")] = target.starts_with('/') ? target.substr(1) : "xl/" + target;
    });
    std::vector<Sheet> found;
    for_each_child(first_child(book.document_element(), "sheets"), "sheet", [&](const pugi::xml_node& node) {
      found.push_back({readable(attribute(node, "name")), targets[attribute(node, "id")]});
    });
    return found;
  }

  void read_sheet(const Sheet& sheet) {
    pugi::xml_document document;
    if (!load(sheet.path, document))
      throw InputError("", drawing_.name, "without its sheet \"" + sheet.name + "\"", "an .xlsx file");
    std::optional<LayerTable> table;
    std::size_t number = 0;
    for (const pugi::xml_node& row : first_child(document.document_element(), "sheetData").children()) {
      if (local(row.name()) != "row") continue;
      number = number_in<std::size_t>(attribute(row, "r")).value_or(number + 1);
      if (!read_row(row, fmt::format("{}, sheet \"{}\" row {}", drawing_.name, sheet.name, number), table)) return;
    }
  }

  // The first row that says something must be a header: false when it is not.
  bool read_row(const pugi::xml_node& row, const std::string& here, std::optional<LayerTable>& table) {
    const std::vector<std::string> cells = cells_of(row);
    const std::vector<std::string_view> views(cells.begin(), cells.end());
    if (std::ranges::all_of(views, &std::string_view::empty) || views.front().starts_with('#')) return true;
    if (table) {
      table->read_row(views, here);
      return true;
    }
    if (!LayerTable::is_header(views)) {
      ++drawing_.passed_over["sheet without a header"];
      return false;
    }
    table.emplace(drawing_, metres_, false).read_header(views, here, fmt::format("{}", fmt::join(views, " ")));
    ++tables_;
    return true;
  }

  [[nodiscard]] std::vector<std::string> cells_of(const pugi::xml_node& row) const {
    std::vector<std::string> cells;
    for (const pugi::xml_node& cell : row.children()) {
      if (local(cell.name()) != "c") continue;
      const std::size_t column = column_in(attribute(cell, "r")).value_or(cells.size());
      if (column >= most_columns) break;
      if (column >= cells.size()) cells.resize(column + 1);
      cells[column] = without_blanks(text_of(cell));
    }
    return cells;
  }

  [[nodiscard]] std::string text_of(const pugi::xml_node& cell) const {
    const std::string type = attribute(cell, "t");
    if (type == "inlineStr") return text_in(first_child(cell, "is"));
    std::string value = first_child(cell, "v").text().get();
    if (type != "s") return value;
    const auto number = number_in<std::size_t>(value);
    if (!number || *number >= texts_.size())
      throw InputError("", drawing_.name, "with a cell of text \"" + readable(value) + "\", which it lacks",
                       "an .xlsx file");
    return texts_[*number];
  }

  ZipArchive archive_;
  double metres_;
  LineDrawing drawing_;
  std::vector<std::string> texts_;
  int tables_ = 0;
};

}  // namespace

LineDrawing read_xlsx(std::string_view text, const std::string& name, double metres) {
  return XlsxReader(text, name, metres > 0 ? metres : 1).read();
}

}  // namespace dda
