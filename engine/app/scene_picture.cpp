#include "engine/app/scene_picture.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/block_layers.h"
#include "engine/app/block_sheet.h"
#include "engine/contact/interface.h"

namespace dda {
namespace {

constexpr double arrow = 24;  // px, of loads

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// A block that is given by itself is its own group; such ones are told apart by their material alone.
std::string kind_of(const SceneParts& scene, std::size_t block) {
  const Model& model = scene.model;
  const std::string& group = scene.groups[block];
  const std::string& material = model.materials[at(model.blocks[block].material)].name;
  if (group.empty() || group == model.blocks[block].name || group == material) return material;
  return model.materials.size() == 1 ? group : group + ", " + material;
}

// What is drawn on top of blocks and joints, in one look, with its line of the key.
struct Mark {
  std::string_view text, stroke, style;
  SvgPath path;
};

class Marks {
 public:
  Marks(const Model& model, BlockSheet& sheet) : model_(model), sheet_(sheet) {}

  void draw() {
    mark("taken out by a stage", "#b3261e", "stroke-width=\"1.5\" stroke-dasharray=\"6 4\"", &Marks::append_removed);
    mark("held as a whole", "#1a2129", "stroke-width=\"2.5\"", &Marks::append_held);
    mark("absorbs waves", "#0e7490", "stroke-width=\"4\" stroke-dasharray=\"2 2\"", &Marks::append_absorbing);
    mark("bolt", "#007a3d", "stroke-width=\"1.6\"", &Marks::append_bolts);
    mark("lining", "#65a30d", "stroke-width=\"4\"", &Marks::append_linings);
    mark("support", "#1a2129", "stroke-width=\"1.2\"", &Marks::append_supports);
    mark("load", "#d4002a", "stroke-width=\"1.5\"", &Marks::append_loads);
  }

  void draw_key() {
    for (const Mark& each : drawn_) sheet_.add_line_to_key(each.stroke, each.text);
  }

 private:
  void mark(std::string_view text, std::string_view stroke, std::string_view style,
            void (Marks::*append)(SvgPath&) const) {
    Mark made{text, stroke, style, {}};
    (this->*append)(made.path);
    if (made.path.empty()) return;
    sheet_.add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" {}/>\n", made.path.text(), stroke, style);
    drawn_.push_back(std::move(made));
  }

  void append_block(int block, SvgPath& path) const { sheet_.append_block(model_.blocks[at(block)].shape, path); }

  void append_removed(SvgPath& path) const {
    for (const Stage& stage : model_.stages)
      for (const int block : stage.removal.blocks) append_block(block, path);
  }

  void append_held(SvgPath& path) const {
    for (const HeldBlock& held : model_.held_blocks) append_block(held.block, path);
  }

  void append_absorbing(SvgPath& path) const {
    for (const ViscousEdge& edge : model_.viscous_edges) sheet_.append_line(edge.from, edge.to, path);
  }

  void append_bolts(SvgPath& path) const {
    for (const Bolt& bolt : model_.bolts)
      for (const BoltLink& link : bolt.links)
        sheet_.append_line(link.point_a - link.reach_a * bolt.direction, link.point_b + link.reach_b * bolt.direction,
                           path);
  }

  void append_linings(SvgPath& path) const {
    for (const Lining& lining : model_.linings)
      for (std::size_t i = 0; i < lining.elements(); ++i)
        sheet_.append_line(lining.start_of(i).point, lining.end_of(i).point, path);
  }

  // A small triangle below the point that is held.
  void append_supports(SvgPath& path) const {
    for (const PointSupport& support : model_.supports) {
      const Vec2 tip = sheet_.place_of(support.point);
      path.move_to(tip);
      path.line_to(tip + Vec2(-4, 7));
      path.line_to(tip + Vec2(4, 7));
      path.close();
    }
  }

  // Arrows end where the load acts.
  void append_loads(SvgPath& path) const {
    for (const PointLoad& load : model_.point_loads) append_arrow(load.point, load.force, path);
    for (const EdgeLoad& load : model_.edge_loads) {
      sheet_.append_line(load.from, load.to, path);
      append_arrow((load.from + load.to) / 2, load.traction, path);
    }
  }

  void append_arrow(const Vec2& point, const Vec2& force, SvgPath& path) const {
    if (force.isZero(0)) return;
    const Vec2 along = Vec2(force.x(), -force.y()).normalized();
    sheet_.append_arrow(sheet_.place_of(point) - arrow * along, along, arrow, path);
  }

  const Model& model_;
  BlockSheet& sheet_;
  std::vector<Mark> drawn_;
};

void add_blocks(const SceneParts& scene, BlockLayers& layers) {
  const Model& model = scene.model;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) layers.add_block(kind_of(scene, i), model.blocks[i].shape);
  for (const Interface& interface : find_interfaces(model))
    if (interface.length > 0) layers.add_joint(model.joints[at(interface.joint)].name, interface.from, interface.to);
}

Box with_room_for_arrows(const Box& blocks) {
  constexpr double room = 0.03;  // of their extent, which is 900 px or more
  return expanded(blocks, room * (blocks.upper - blocks.lower).maxCoeff());
}

}  // namespace

std::string scene_picture(const SceneParts& scene, const std::optional<Box>& part) {
  BlockSheet sheet(part ? *part : with_room_for_arrows(bounding_box(scene.model)));
  BlockLayers layers(sheet);
  Marks marks(scene.model, sheet);
  add_blocks(scene, layers);
  if (part) sheet.begin_clipped();
  layers.draw();
  marks.draw();
  if (part) sheet.end_clipped();
  layers.draw_key();
  marks.draw_key();
  return sheet.text(320);
}

}  // namespace dda
