// A scene whose rock is cut, as a scene of polygons and joint lines that gives the same.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

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
};

// `folder` is where the new scene will stand: paths of records are written relative to it. The new scene has been
// read, so it is known to work. Throws InputError, also for a scene without rock.
CutScene cut_scene(const std::filesystem::path& file, const std::filesystem::path& folder,
                   const std::function<void(std::string_view)>& progress = {});

}  // namespace dda
