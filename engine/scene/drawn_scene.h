// A drawing without a scene: what it does not say is assumed, so that it can be cut, looked at and run.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/run_data.h"
#include "engine/model/model.h"
#include "engine/scene/read_rock.h"

namespace dda {

// What to make of a drawing, in the words of a scene.
struct DrawingWords {
  std::map<std::string, std::string> layers;  // by name: "rock", "tunnel", ...
  std::string unit;                           // of coordinates; empty: what the drawing says
  std::filesystem::path run_data;             // of df, which take the place of assumptions; empty: none
};

// Those that the words name, for the points of the drawing. Throws InputError.
std::optional<RunData> run_data_for(const std::filesystem::path& drawing, const DrawingWords& words);

// A scene with the drawing as its rock, and material, joint and stages that are assumed or those of the data.
nlohmann::json scene_around(const std::filesystem::path& drawing, const DrawingWords& words,
                            const std::optional<RunData>& data);

// Points and lines that the drawing marks, as entries of the scene: supports at fix points, else of a level bottom;
// measurements at measure points; edges that absorb waves. The description says what was assumed. With data nothing is:
// they have loads and steps too, and what no fix point holds is free. Throws InputError for a point outside of all
// blocks.
void add_marked_places(const Rock& rock, const std::vector<Block>& blocks, const std::optional<RunData>& data,
                       nlohmann::json& scene);

}  // namespace dda
