// What layers of a drawing mean.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/drawing/line_drawing.h"

namespace dda {

// The layers of Appendix A of the thesis.
enum class LayerRole {
  boundary,            // outline of the rock, and of holes in it
  rock,                // joints
  tunnel,              // outlines of openings, cut like the rest and to be excavated
  removable_hole,      // the same, or points inside of openings to be excavated
  hole_point,          // points inside of openings that are no rock
  blast,               // joints around a place of blasting; points there
  absorbing_boundary,  // lines along the boundary that absorb waves
  fix_point,
  load_point,
  measure_point,
  ignored,
  // These two are known by the beginning of the layer's name alone, as tables have no words for them.
  block,       // outlines of blocks, each closed in itself
  block_hole,  // of holes in blocks
};

// A layer that says what it is by the beginning of its name, as drawings do that dda cut wrote: "block NAME" has
// outlines of the blocks of a group, "hole of NAME" those of holes in them, "joint NAME" joints (their role is rock).
struct NamedLayer {
  LayerRole role = LayerRole::block;
  std::string name;
};

// Returns nothing for a layer whose name does not begin so. Blanks, hyphens and underscores are one, as in other names
// of layers.
std::optional<NamedLayer> named_layer(std::string_view layer);

std::string layer_for(const NamedLayer& named);

// The name by which drawings and scenes know the joint of all lines that name none.
inline constexpr std::string_view default_joint_name = "default";

struct LayerUse {
  LayerRole role = LayerRole::ignored;
  std::string joint;          // along its lines; empty: the default joint
  bool construction = false;  // the joint is bonded: the lines only cut
};

// "boundary", "rock", ...: the words a table of layers may use, in the order of LayerRole.
const std::vector<std::string>& role_names();

// Which layer means what: by a table of one's own first, then by the names of Appendix A, whether they are written with
// capitals, blanks, hyphens or underscores, then by the beginning of named layers; AutoCAD's own "Defpoints" is
// ignored.
class Layers {
 public:
  explicit Layers(const std::map<std::string, LayerUse>& table);

  // Throws InputError for a layer that has no meaning; `origin` is what lies on it.
  [[nodiscard]] const LayerUse& use_of(const std::string& layer, const std::string& origin);

 private:
  std::map<std::string, LayerUse> uses_;        // by bare name
  std::map<std::string, LayerUse> named_uses_;  // of named layers, by their whole name
};

// A name as layers are compared: in lower case without blanks, hyphens and underscores.
std::string bare_layer(std::string_view name);

}  // namespace dda
