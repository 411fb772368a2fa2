// A sheet (SVG) on which blocks are drawn to scale, with a key below them: what pictures of cut rock and of key blocks
// share.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "engine/model/extent.h"
#include "engine/view/svg_path.h"

namespace dda {

class BlockSheet {
 public:
  // `blocks` (m) is the box around all that will be drawn.
  explicit BlockSheet(const Box& blocks);
  explicit BlockSheet(const Model& model) : BlockSheet(bounding_box(model)) {}

  [[nodiscard]] double scale() const { return scale_; }  // px per m
  [[nodiscard]] Vec2 place_of(const Vec2& point) const;  // px, y downwards
  void append_line(const Vec2& from, const Vec2& to, SvgPath& path) const;
  void append_block(const Polygon& shape, SvgPath& path) const;  // with its holes

  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(content_), format, std::forward<Values>(values)...);
  }

  void draw_blocks(const SvgPath& blocks, std::string_view fill);
  // What is added in between shows within the box alone.
  void begin_clipped();
  void end_clipped() { content_ += "</g>\n"; }

  // From `foot` (px) along the unit vector `along` (px, y downwards).
  static void append_arrow(const Vec2& foot, const Vec2& along, double length, SvgPath& path);
  // From `start` (m) along the unit vector `way`, `length` px long.
  void draw_arrow(const Vec2& start, const Vec2& way, double length);

  // Lines of the key, from above. `text` may hold any characters.
  void add_area_to_key(std::string_view fill, std::string_view text);
  void add_line_to_key(std::string_view stroke, std::string_view text);

  // The whole picture, at least `width_of_key` (px) wide.
  [[nodiscard]] std::string text(double width_of_key) const;

 private:
  void add_text_to_key(std::string_view text);

  Box box_;
  double scale_ = 1;
  double next_line_ = 0;  // px, of the key
  std::string content_;
};

}  // namespace dda
