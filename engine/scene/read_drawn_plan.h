// "drawing" of rock in a scene.
#pragma once

#include <filesystem>

#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

struct DrawnPlan {
  RockPlan plan;
  std::vector<std::string> remarks;  // what the drawing left unsaid, and what of it was passed over
};

// `field` is the name of a file, relative to `folder`, or {"file": ..., "layers": ..., ...}. Ends of lines within
// `reach` (m) belong together; 0: the drawing's default. Of errors in the drawing the field is its name and the line.
DrawnPlan read_drawn_plan(const Field& field, const std::filesystem::path& folder, const Model& model, double reach);

// Entries of "layers" that may name a joint.
std::vector<Field> layer_entries(const Field& drawing);

}  // namespace dda
