#include "engine/app/cut_picture.h"

#include "engine/app/block_layers.h"
#include "engine/app/block_sheet.h"

namespace dda {
namespace {

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

void add(const CutEntry& entry, const CutScene& scene, BlockLayers& layers) {
  for (const CutBlock& block : entry.cut.blocks) {
    const std::string& group = group_name(entry.rock, block);
    layers.add_block(block.material.empty() ? group : group + ", " + block.material, block.shape);
  }
  for (const CutJoint& run : entry.cut.joints) layers.add_joint(joint_name(scene, run), run.from, run.to);
}

}  // namespace

std::string cut_picture(const CutScene& scene) {
  BlockSheet sheet(box_around(scene));
  BlockLayers layers(sheet);
  for (const CutEntry& entry : scene.entries) add(entry, scene, layers);
  layers.draw();
  layers.draw_key();
  return sheet.text(320);
}

}  // namespace dda
