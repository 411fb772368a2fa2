#include "engine/app/cut_picture.h"

#include <array>
#include <map>
#include <string_view>

#include "engine/app/block_sheet.h"

namespace dda {
namespace {

constexpr std::array<std::string_view, 8> fills{"#dfe7ee", "#f3dfc1", "#d3e8d0", "#ecd6e6",
                                                "#f4ebb5", "#cfe4e8", "#e5d9cf", "#d9d9f0"};
constexpr std::array<std::string_view, 8> strokes{"#3d4a57", "#c2410c", "#1d6fb8", "#15803d",
                                                  "#9333ea", "#b45309", "#0f766e", "#be123c"};

Box box_around(const CutScene& scene) {
  Box box;
  for (const CutEntry& entry : scene.entries) {
    for (const Vec2& corner : entry.rock.plan.boundary) box = expanded(box, corner);
    for (const CutBlock& block : entry.cut.blocks) {
      for (const Vec2& corner : block.shape.outer) box = expanded(box, corner);
    }
  }
  return box;
}

class Picture {
 public:
  explicit Picture(const CutScene& scene) : scene_(scene), sheet_(box_around(scene)) {
    for (const CutEntry& entry : scene.entries) collect(entry);
  }

  std::string text() {
    std::size_t number = 0;
    for (const auto& [name, path] : areas_)
      sheet_.add("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#8a96a3\" stroke-width=\"0.4\"/>\n",
                 path.text(), fills[number++ % fills.size()]);
    number = 0;
    for (const auto& [name, path] : runs_)
      sheet_.add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n", path.text(),
                 strokes[number++ % strokes.size()]);
    draw_key();
    return sheet_.text(320);
  }

 private:
  void collect(const CutEntry& entry) {
    for (const CutBlock& block : entry.cut.blocks) {
      const std::string& group = group_name(entry.rock, block);
      sheet_.append_block(block.shape, areas_[block.material.empty() ? group : group + ", " + block.material]);
    }
    for (const CutJoint& run : entry.cut.joints) sheet_.append_line(run.from, run.to, runs_[joint_name(scene_, run)]);
  }

  void draw_key() {
    std::size_t number = 0;
    for (const auto& [name, path] : areas_) sheet_.add_area_to_key(fills[number++ % fills.size()], name);
    number = 0;
    for (const auto& [name, path] : runs_) sheet_.add_line_to_key(strokes[number++ % strokes.size()], "joint " + name);
  }

  const CutScene& scene_;
  BlockSheet sheet_;
  std::map<std::string, SvgPath> areas_;  // by group and material
  std::map<std::string, SvgPath> runs_;   // by joint
};

}  // namespace

std::string cut_picture(const CutScene& scene) { return Picture(scene).text(); }

}  // namespace dda
