// Run data of df in the words of a scene: they say what a drawing alone leaves to assumptions.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/drawing/line_drawing.h"
#include "engine/drawing/run_data.h"
#include "engine/model/model.h"

namespace dda {

// How many fixed and load points a drawing has: what tables of df are for.
int fixed_and_loaded(const LineDrawing& drawing);

// Materials, joints, gravity, and which joint is along which lines, in a scene around the drawing that nobody has cut
// yet. Throws InputError for a material or joint that the data do not have.
void take_materials_and_joints(const RunData& data, const LineDrawing& drawing, nlohmann::json& scene);

// Steps, stresses and velocities at the start in the scene with all blocks written out.
void take_steps_and_state(const RunData& data, const std::vector<Block>& blocks, nlohmann::json& scene);

// What a table makes of a point at `place` of a block: loads, or displacements of what holds it there.
void add_loads(const PointTable& table, const nlohmann::json& place, nlohmann::json& scene);
void add_moved_supports(const PointTable& table, const nlohmann::json& place, nlohmann::json& scene);

}  // namespace dda
