// A lining of sprayed concrete: a thin beam that is bonded to the wall of an opening.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/withdrawal.h"

namespace dda {

// Where the beam follows the rock: the middle of a face of the wall, as drawn.
struct LiningNode {
  int block = 0;
  Vec2 point = Vec2::Zero();     // m
  Vec2 tangent = Vec2::UnitX();  // unit, along the face; the rock lies on its left
};

// A chain of beam elements, each from one node to the next. The nodes move and turn with the faces of their blocks, so
// that the beam has no unknowns of its own. It has neither weight nor mass.
struct Lining {
  std::string name;
  std::vector<LiningNode> nodes;  // with the rock on the left
  bool closed = false;            // an element leads from the last node to the first
  double thickness = 0;           // m
  double young = 0;               // Pa
  double poisson = 0;
  double compressive_strength = std::numeric_limits<double>::infinity();  // Pa, of the section, a positive number
  double tensile_strength = std::numeric_limits<double>::infinity();      // Pa
  int first_stage = 0;  // sprayed at the start of this stage, free of stress
  Withdrawal withdrawal = {};

  [[nodiscard]] std::size_t elements() const { return closed ? nodes.size() : nodes.size() - 1; }
  [[nodiscard]] const LiningNode& start_of(std::size_t element) const { return nodes[element]; }
  [[nodiscard]] const LiningNode& end_of(std::size_t element) const { return nodes[(element + 1) % nodes.size()]; }
  [[nodiscard]] bool yields() const {
    return compressive_strength != std::numeric_limits<double>::infinity() ||
           tensile_strength != std::numeric_limits<double>::infinity();
  }
};

}  // namespace dda
