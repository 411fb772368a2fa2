#include "engine/app/cut_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "engine/geometry/box.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr double width = 960;        // px, of the blocks
constexpr double most_height = 900;  // px
constexpr double margin = 16;        // px
constexpr double line_height = 22;   // px, of the key
constexpr std::array<std::string_view, 8> fills{"#dfe7ee", "#f3dfc1", "#d3e8d0", "#ecd6e6",
                                                "#f4ebb5", "#cfe4e8", "#e5d9cf", "#d9d9f0"};
constexpr std::array<std::string_view, 8> strokes{"#3d4a57", "#c2410c", "#1d6fb8", "#15803d",
                                                  "#9333ea", "#b45309", "#0f766e", "#be123c"};

class Picture {
 public:
  explicit Picture(const CutScene& scene) : scene_(scene) {
    for (const CutEntry& entry : scene.entries) {
      const Box own = bounding_box(entry.rock.plan.boundary);
      box_ = expanded(expanded(box_, own.lower), own.upper);
    }
    const Vec2 size = box_.upper - box_.lower;
    scale_ = std::min(width / size.x(), most_height / size.y());
    for (const CutEntry& entry : scene.entries) collect(entry);
  }

  std::string text() {
    const Vec2 size = scale_ * (box_.upper - box_.lower);
    const double key = line_height * static_cast<double>(areas_.size() + runs_.size());
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
        "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"14\" fill=\"#1a2129\">\n",
        std::max(size.x(), 320.0) + 2 * margin, size.y() + 3 * margin + key);
    add("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    std::size_t number = 0;
    for (const auto& [name, path] : areas_)
      add("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#8a96a3\" stroke-width=\"0.4\"/>\n", path.text(),
          fills[number++ % fills.size()]);
    number = 0;
    for (const auto& [name, path] : runs_)
      add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n", path.text(),
          strokes[number++ % strokes.size()]);
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

  void collect(const CutEntry& entry) {
    for (const CutBlock& block : entry.cut.blocks) {
      const std::string& group = group_name(entry.rock, block);
      SvgPath& path = areas_[block.material.empty() ? group : group + ", " + block.material];
      append(block.shape.outer, path);
      for (const Ring& hole : block.shape.holes) append(hole, path);
    }
    for (const CutJoint& run : entry.cut.joints) {
      SvgPath& path = runs_[run.joint.empty() ? scene_.joint_names.front() : run.joint];
      path.move_to(on_picture(run.from));
      path.line_to(on_picture(run.to));
    }
  }

  void draw_key(double top) {
    double y = top;
    std::size_t number = 0;
    for (const auto& [name, path] : areas_) {
      add("<rect x=\"{}\" y=\"{:.1f}\" width=\"24\" height=\"14\" fill=\"{}\" stroke=\"#8a96a3\"/>", margin, y,
          fills[number++ % fills.size()]);
      add("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", margin + 34, y + 12, escaped(name));
      y += line_height;
    }
    number = 0;
    for (const auto& [name, path] : runs_) {
      add("<path d=\"M{} {:.1f}h24\" stroke=\"{}\" stroke-width=\"2\"/>", margin, y + 7,
          strokes[number++ % strokes.size()]);
      add("<text x=\"{}\" y=\"{:.1f}\">joint {}</text>\n", margin + 34, y + 12, escaped(name));
      y += line_height;
    }
  }

  static std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) text += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return text;
  }

  const CutScene& scene_;
  Box box_;
  double scale_ = 1;
  std::map<std::string, SvgPath> areas_;  // by group and material
  std::map<std::string, SvgPath> runs_;   // by joint
  std::string text_;
};

}  // namespace

std::string cut_picture(const CutScene& scene) { return Picture(scene).text(); }

}  // namespace dda
