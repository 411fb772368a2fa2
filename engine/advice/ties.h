// Bolts and linings as ties between blocks: waves are foretold in rock without them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/advice/acting_place.h"
#include "engine/model/model.h"

namespace dda {

struct Tie {
  std::string name;      // for people, of the bolt or lining
  ActingPlace place;     // of its part between two blocks
  double stiffness = 0;  // N per m of thickness: force over strain along it
  double length = 0;     // m
};

// Those that act in the stage.
std::vector<Tie> ties_in(const Model& model, std::size_t stage);

}  // namespace dda
