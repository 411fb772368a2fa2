#include "engine/app/keyblocks_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/geometry/box.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr double width = 960;        // px, of the blocks
constexpr double most_height = 900;  // px
constexpr double margin = 16;        // px
constexpr double line_height = 22;   // px, of the key

// Kinds of blocks as they are drawn: by type, then those that were not asked for.
enum Kind : std::size_t { key, friction_held, stable, tapered, other, taken_out, kinds };
struct Look {
  std::string_view fill, text;
};
constexpr std::array<Look, kinds> looks{{{"#e2725b", "I: key block, moves unless it is held"},
                                         {"#f2c14e", "II: held by friction or cohesion"},
                                         {"#a8cf9e", "III: can be removed, but is pressed onto its neighbours"},
                                         {"#b9cbe0", "IV: has a free face, cannot be removed"},
                                         {"#e9e9e6", "without a free face that was asked for, or held"},
                                         {"#ffffff", "taken out"}}};

class Picture {
 public:
  Picture(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model)
      : report_(report), model_(model), kind_of_(model.blocks.size(), other) {
    for (const Block& block : model.blocks) {
      const Box own = bounding_box(block.shape);
      box_ = expanded(expanded(box_, own.lower), own.upper);
    }
    const Vec2 size = box_.upper - box_.lower;
    scale_ = std::min(width / size.x(), most_height / size.y());
    for (std::size_t block = 0; block < kind_of_.size(); ++block) {
      if (question.is_void[block]) kind_of_[block] = taken_out;
    }
    for (const KeyBlock& block : report.blocks) {
      for (const int each : block.body.blocks) kind_of_[static_cast<std::size_t>(each)] = static_cast<Kind>(block.type);
    }
  }

  std::string text() {
    const Vec2 size = scale_ * (box_.upper - box_.lower);
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
        "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"14\" fill=\"#1a2129\">\n",
        std::max(size.x(), 420.0) + 2 * margin,
        size.y() + 3 * margin + line_height * static_cast<double>(looks.size()));
    add("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    draw_blocks();
    draw_joints();
    for (const KeyBlock& block : report_.blocks) draw_way(block);
    draw_key(size.y() + 2 * margin);
    return text_ + "</svg>\n";
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  [[nodiscard]] Vec2 on_picture(const Vec2& point) const {
    return {margin + scale_ * (point.x() - box_.lower.x()), margin + scale_ * (box_.upper.y() - point.y())};
  }

  void append(const Ring& ring, SvgPath& path) const {
    path.move_to(on_picture(ring.front()));
    for (std::size_t i = 1; i < ring.size(); ++i) path.line_to(on_picture(ring[i]));
    path.close();
  }

  void draw_blocks() {
    std::array<SvgPath, kinds> paths;
    for (std::size_t block = 0; block < kind_of_.size(); ++block) {
      SvgPath& path = paths[kind_of_[block]];
      append(model_.blocks[block].shape.outer, path);
      for (const Ring& hole : model_.blocks[block].shape.holes) append(hole, path);
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      if (!paths[kind].empty())
        add("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#c3cad1\" stroke-width=\"0.5\"/>\n",
            paths[kind].text(), looks[kind].fill);
    }
  }

  // Of the bodies asked for: thin where they touch others, thick where they are free.
  void draw_joints() {
    SvgPath joints;
    SvgPath free;
    for (const KeyBlock& block : report_.blocks) {
      for (const JointFace& face : block.body.joints) append_line(face.from, face.to, joints);
      for (const FreeFace& face : block.body.free_faces) append_line(face.from, face.to, free);
    }
    add("<path d=\"{}\" fill=\"none\" stroke=\"#3d4a57\" stroke-width=\"0.8\"/>\n", joints.text());
    add("<path d=\"{}\" fill=\"none\" stroke=\"#1a2129\" stroke-width=\"2\"/>\n", free.text());
  }

  void append_line(const Vec2& from, const Vec2& to, SvgPath& path) const {
    path.move_to(on_picture(from));
    path.line_to(on_picture(to));
  }

  // An arrow along the way that a body slides or falls, and its factor of safety.
  void draw_way(const KeyBlock& block) {
    if (block.motion.direction == Vec2::Zero()) return;
    const double length = std::clamp(scale_ * std::sqrt(block.body.area) / 2, 8.0, 40.0);  // px
    const Vec2 way(block.motion.direction.x(), -block.motion.direction.y());
    const Vec2 start = on_picture(block.body.centroid);
    const Vec2 tip = start + length * way;
    const Vec2 barb(-way.y(), way.x());
    SvgPath arrow;
    arrow.move_to(start);
    arrow.line_to(tip);
    arrow.move_to(tip - 0.3 * length * way + 0.2 * length * barb);
    arrow.line_to(tip);
    arrow.line_to(tip - 0.3 * length * way - 0.2 * length * barb);
    add("<path d=\"{}\" fill=\"none\" stroke=\"#1a2129\" stroke-width=\"1.5\"/>\n", arrow.text());
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" text-anchor=\"middle\">{:.2f}</text>\n", start.x(),
        start.y() - 4, block.motion.factor_of_safety);
  }

  void draw_key(double top) {
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const double y = top + static_cast<double>(kind) * line_height;
      add("<rect x=\"{}\" y=\"{:.1f}\" width=\"24\" height=\"14\" fill=\"{}\" stroke=\"#8a96a3\"/>", margin, y,
          looks[kind].fill);
      add("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", margin + 34, y + 12, looks[kind].text);
    }
  }

  const KeyBlockReport& report_;
  const Model& model_;
  std::vector<Kind> kind_of_;
  Box box_;
  double scale_ = 1;
  std::string text_;
};

}  // namespace

std::string keyblocks_picture(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model) {
  return Picture(report, question, model).text();
}

}  // namespace dda
