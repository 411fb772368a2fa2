// Tables of lines and points on layers, whatever file they come from: a header that names columns, then rows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/drawing/line_drawing.h"

namespace dda {

class LayerTable {
 public:
  // `metres` is a unit of the coordinates. Where commas do not part cells they may part decimals.
  LayerTable(LineDrawing& drawing, double metres, bool decimal_commas)
      : pencil_(drawing), metres_(metres), decimal_commas_(decimal_commas) {}

  // Whether one of the cells names the column of layers.
  static bool is_header(const std::vector<std::string_view>& cells);

  // `here` says where, for messages: "plan.csv line 1"; `text` is what stands there.
  void read_header(const std::vector<std::string_view>& cells, const std::string& here, std::string_view text);
  void read_row(const std::vector<std::string_view>& cells, const std::string& here);

 private:
  enum Column { layer, x1, y1, x2, y2, x, y, column_count };
  struct Heading;
  static const std::array<Heading, 13> headings;

  [[nodiscard]] std::string_view cell(Column column) const;
  [[nodiscard]] bool given(std::initializer_list<Column> columns) const;
  [[nodiscard]] Vec2 place(Column first, Column second) const;
  [[nodiscard]] double coordinate(Column column) const;

  Pencil pencil_;
  double metres_;
  bool decimal_commas_;
  std::array<std::optional<std::size_t>, column_count> columns_;
  std::size_t width_ = 0;  // cells of the header
  bool has_lines_ = false, has_points_ = false;
  const std::vector<std::string_view>* cells_ = nullptr;  // of the row that is read
  const std::string* here_ = nullptr;
};

inline constexpr const char* table_header =
    "a header with layer and x1, y1, x2, y2 of lines, or x, y of points, or both";

}  // namespace dda
