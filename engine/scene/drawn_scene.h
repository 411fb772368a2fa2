// A drawing without a scene: what it does not say is assumed, so that it can be cut, looked at and run.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/scene/read_rock.h"

namespace dda {

// What to make of a drawing, in the words of a scene.
struct DrawingWords {
  std::map<std::string, std::string> layers;  // by name: "rock", "tunnel", ...
  std::string unit;                           // of coordinates; empty: what the drawing says
};

// A scene with the drawing as its rock, and assumed material, joint and stages.
nlohmann::json scene_around(const std::filesystem::path& drawing, const DrawingWords& words);

// Points and lines that the drawing marks, as entries of the scene: supports at fix points, else of a level bottom;
// measurements at measure points; edges that absorb waves. The description says what was assumed. Throws InputError for
// a point outside of all blocks.
void add_marked_places(const Rock& rock, const std::vector<Block>& blocks, nlohmann::json& scene);

}  // namespace dda
