#include "engine/app/block_sheet.h"

#include <algorithm>

#include "engine/record/vtp_file.h"

namespace dda {
namespace {

constexpr double width = 960;        // px, of the blocks
constexpr double most_height = 900;  // px
constexpr double margin = 16;        // px
constexpr double line_height = 22;   // px, of the key

void append_ring(const Ring& ring, const BlockSheet& sheet, SvgPath& path) {
  path.move_to(sheet.place_of(ring.front()));
  for (std::size_t i = 1; i < ring.size(); ++i) path.line_to(sheet.place_of(ring[i]));
  path.close();
}

}  // namespace

BlockSheet::BlockSheet(const Box& blocks) : box_(blocks) {
  const Vec2 size = box_.upper - box_.lower;
  scale_ = std::min(width / size.x(), most_height / size.y());
  next_line_ = scale_ * size.y() + 2 * margin;
}

Vec2 BlockSheet::place_of(const Vec2& point) const {
  return {margin + scale_ * (point.x() - box_.lower.x()), margin + scale_ * (box_.upper.y() - point.y())};
}

void BlockSheet::append_line(const Vec2& from, const Vec2& to, SvgPath& path) const {
  path.move_to(place_of(from));
  path.line_to(place_of(to));
}

void BlockSheet::append_block(const Polygon& shape, SvgPath& path) const {
  append_ring(shape.outer, *this, path);
  for (const Ring& hole : shape.holes) append_ring(hole, *this, path);
}

void BlockSheet::draw_blocks(const SvgPath& blocks, std::string_view fill) {
  if (!blocks.empty())
    add("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#c3cad1\" stroke-width=\"0.5\"/>\n", blocks.text(),
        fill);
}

void BlockSheet::begin_clipped() {
  const Vec2 size = scale_ * (box_.upper - box_.lower);
  add("<clipPath id=\"part\"><rect x=\"{0}\" y=\"{0}\" width=\"{1:.1f}\" height=\"{2:.1f}\"/></clipPath>\n"
      "<g clip-path=\"url(#part)\">\n",
      margin, size.x(), size.y());
}

void BlockSheet::append_arrow(const Vec2& foot, const Vec2& along, double length, SvgPath& path) {
  const Vec2 barb(-along.y(), along.x());
  const Vec2 tip = foot + length * along;
  path.move_to(foot);
  path.line_to(tip);
  path.move_to(tip - 0.3 * length * along + 0.2 * length * barb);
  path.line_to(tip);
  path.line_to(tip - 0.3 * length * along - 0.2 * length * barb);
}

void BlockSheet::draw_arrow(const Vec2& start, const Vec2& way, double length) {
  SvgPath arrow;
  append_arrow(place_of(start), Vec2(way.x(), -way.y()), length, arrow);
  add("<path d=\"{}\" fill=\"none\" stroke=\"#1a2129\" stroke-width=\"1.5\"/>\n", arrow.text());
}

void BlockSheet::add_area_to_key(std::string_view fill, std::string_view text) {
  add("<rect x=\"{}\" y=\"{:.1f}\" width=\"24\" height=\"14\" fill=\"{}\" stroke=\"#8a96a3\"/>", margin, next_line_,
      fill);
  add_text_to_key(text);
}

void BlockSheet::add_line_to_key(std::string_view stroke, std::string_view text) {
  add("<path d=\"M{} {:.1f}h24\" stroke=\"{}\" stroke-width=\"2\"/>", margin, next_line_ + 7, stroke);
  add_text_to_key(text);
}

void BlockSheet::add_text_to_key(std::string_view text) {
  add("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", margin + 34, next_line_ + 12, xml_escaped(text));
  next_line_ += line_height;
}

std::string BlockSheet::text(double width_of_key) const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
             "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"14\" fill=\"#1a2129\">\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
             std::max(scale_ * (box_.upper.x() - box_.lower.x()), width_of_key) + 2 * margin, next_line_ + margin) +
         content_ + "</svg>\n";
}

}  // namespace dda
