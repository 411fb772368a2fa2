#include "verification/study/markdown.h"

#include <fmt/format.h>

namespace verify {
namespace {

// A bar would end the cell.
std::string cell_of(const std::string& text) {
  std::string cell;
  for (const char letter : text) {
    if (letter == '|') cell += '\\';
    cell += letter;
  }
  return cell;
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += fmt::format(" {} |", cell_of(cell));
  return row + "\n";
}

// The header with each column's group before its name: Markdown has no cells over several columns.
std::vector<std::string> full_header(const Table& table) {
  std::vector<std::string> header = table.header;
  std::size_t column = 0;
  for (const ColumnGroup& group : table.groups) {
    for (int i = 0; i < group.columns; ++i, ++column)
      if (!group.title.empty()) header.at(column) = fmt::format("{}: {}", group.title, header[column]);
  }
  return header;
}

std::string rule_of(const Table& table) {
  std::string rule = "|";
  for (std::size_t i = 0; i < table.header.size(); ++i) rule += table.numeric && i > 0 ? "---:|" : "---|";
  return rule + "\n";
}

struct Renderer {
  std::string operator()(const Paragraph& paragraph) const { return paragraph.text + "\n\n"; }

  std::string operator()(const Bullets& bullets) const {
    std::string text;
    for (const std::string& item : bullets.items) text += "- " + item + "\n";
    return text + "\n";
  }

  std::string operator()(const Table& table) const {
    std::string text = table.caption.empty() ? "" : table.caption + "\n\n";
    text += row_of(full_header(table)) + rule_of(table);
    for (const std::vector<std::string>& row : table.rows) text += row_of(row);
    return text + "\n";
  }

  std::string operator()(const Figure& figure) const {
    return fmt::format("![{}]({})\n\n{}\n\n", figure.file, figure.file, figure.caption);
  }
};

}  // namespace

std::string to_markdown(const Document& document) {
  std::string text = fmt::format("# {}\n\n{}\n\n", document.title, document.subtitle);
  for (const KeyFigure& figure : document.key_figures) text += fmt::format("- **{}** {}\n", figure.value, figure.label);
  if (!document.key_figures.empty()) text += "\n";
  for (const Section& section : document.sections) {
    text += fmt::format("## {}\n\n", section.title);
    for (const Piece& piece : section.pieces) text += std::visit(Renderer(), piece);
  }
  return text + document.footer + "\n";
}

}  // namespace verify
