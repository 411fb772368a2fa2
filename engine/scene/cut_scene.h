// A scene whose rock is cut, as a scene of polygons and joint lines that gives the same; a drawing, as such a scene
// with assumptions for what a drawing does not say.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/drawn_scene.h"
#include "engine/scene/read_rock.h"

namespace dda {

struct CutEntry {
  Rock rock;
  CutRock cut;
};

struct CutScene {
  std::vector<CutEntry> entries;         // the rocks of the scene, in order
  std::string text;                      // of the new scene
  std::vector<std::string> joint_names;  // of the scene, the default first
  std::vector<std::string> material_names;
};

inline const std::string& material_name(const CutScene& scene, const CutEntry& entry, const CutBlock& block) {
  return block.material.empty() ? scene.material_names[static_cast<std::size_t>(entry.rock.group.material)]
                                : block.material;
}

// The scene's name of the joint along `run`.
inline const std::string& joint_name(const CutScene& scene, const CutJoint& run) {
  return run.joint.empty() ? scene.joint_names.front() : run.joint;
}

// `folder` is where the new scene will stand: paths of records are written relative to it. The new scene has been
// read as a document, so it is known to work. Throws InputError, also for a scene without rock.
// `words` are for a drawing; a scene has its own.
// `meanwhile` is called while the new scene is being checked, on a thread of its own and with all but its text.
using UseOfCut = std::function<void(const CutScene&)>;
CutScene cut_scene(const std::filesystem::path& file, const std::filesystem::path& folder,
                   const DrawingWords& words = {}, const std::function<void(std::string_view)>& progress = {},
                   const UseOfCut& meanwhile = {});

}  // namespace dda
