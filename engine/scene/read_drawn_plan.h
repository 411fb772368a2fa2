// "drawing" of rock in a scene.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

struct DrawnPlan {
  std::string name;              // of the drawing, for messages
  bool has_hatches = false;      // which are passed over, outlines too
  std::set<std::string> layers;  // on which something is drawn
  RockPlan plan;
  std::vector<std::string> remarks;  // what the drawing left unsaid, and what of it was passed over
};

// `field` is the name of a file, relative to `folder`, or {"file": ..., "layers": ..., ...}. Ends of lines within
// `reach` (m) belong together; 0: the drawing's default. Of errors in the drawing the field is its name and the line.
DrawnPlan read_drawn_plan(const Field& field, const std::filesystem::path& folder, const Model& model, double reach);

// Throws an InputError that says where a boundary was looked for.
[[noreturn]] void refuse_without_boundary(const DrawnPlan& drawn);

// What a drawing names by itself, without the table of a scene.
struct DrawnNames {
  std::set<std::string> joints;  // but the default one
  std::set<std::string> materials;
};
// `name` stands for the file in messages.
DrawnNames drawn_names(const std::filesystem::path& file, const std::string& name);

// The same of the drawing of a scene's rock, relative to `folder`.
DrawnNames drawn_names(const Field& field, const std::filesystem::path& folder);

// Entries of "layers" that may name a joint.
std::vector<Field> layer_entries(const Field& drawing);

}  // namespace dda
