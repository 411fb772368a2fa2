// What layers of a drawing mean.
#pragma once

#include <map>
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
};

struct LayerUse {
  LayerRole role = LayerRole::ignored;
  std::string joint;          // along its lines; empty: the default joint
  bool construction = false;  // the joint is bonded: the lines only cut
};

// "boundary", "rock", ...: the words a table of layers may use, in the order of LayerRole.
const std::vector<std::string>& role_names();

// Which layer means what: by a table of one's own first, then by the names of Appendix A, whether they are written with
// capitals, blanks, hyphens or underscores; AutoCAD's own "Defpoints" is ignored.
class Layers {
 public:
  explicit Layers(const std::map<std::string, LayerUse>& table);

  // InputError for a layer that has no meaning; `origin` is what lies on it.
  [[nodiscard]] const LayerUse& use_of(const std::string& layer, const std::string& origin) const;

 private:
  std::map<std::string, LayerUse> uses_;  // by bare name
};

// A name as layers are compared: in lower case without blanks, hyphens and underscores.
std::string bare_layer(std::string_view name);

}  // namespace dda
