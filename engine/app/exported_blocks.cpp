#include "engine/app/exported_blocks.h"

#include <fmt/format.h>

#include <map>

namespace dda {

BlockDrawing drawing_of_blocks(const CutScene& scene) {
  BlockDrawing drawing;
  for (const CutEntry& entry : scene.entries) {
    std::map<std::string, int> counts;
    for (const CutBlock& block : entry.cut.blocks) {
      const std::string& group = group_name(entry.rock, block);
      drawing.blocks.push_back(
          {group, fmt::format("{} {}", group, ++counts[group]), block.shape, material_name(scene, entry, block)});
    }
    for (const CutJoint& run : entry.cut.joints) drawing.joints.push_back({joint_name(scene, run), run.from, run.to});
  }
  return drawing;
}

}  // namespace dda
