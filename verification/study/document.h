// A report as data: written once, rendered as Markdown and as HTML. Texts are UTF-8 with `code` and **bold** marked as
// in Markdown, and nothing else.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace verify {

struct Paragraph {
  std::string text;
};

struct Bullets {
  std::vector<std::string> items;
};

// A heading over several neighbouring columns (in Markdown before the name of each). An empty title leaves them
// without.
struct ColumnGroup {
  std::string title;
  int columns = 1;
};

struct Table {
  std::string caption;
  std::vector<ColumnGroup> groups;  // none, or covering all columns
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
  bool numeric = true;                         // all columns but the first are numbers, set to the right
  std::vector<int> breaks;                     // rows that start a new part of the table
};

// An SVG file beside the report. HTML includes its text, Markdown links it.
struct Figure {
  std::string file;
  std::string caption;
};

using Piece = std::variant<Paragraph, Bullets, Table, Figure>;

struct Section {
  std::string title;
  std::vector<Piece> pieces;
};

// A number to be seen first.
struct KeyFigure {
  std::string value;
  std::string label;
};

struct Document {
  std::string title;
  std::string subtitle;
  std::vector<KeyFigure> key_figures;
  std::vector<Section> sections;
  std::string footer;
};

}  // namespace verify
