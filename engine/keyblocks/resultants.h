// What acts on each body besides its neighbours: weight, shaking, loads, pretensioned bolts.
#pragma once

#include <string>
#include <vector>

#include "engine/keyblocks/rock_bodies.h"
#include "engine/keyblocks/turning.h"

namespace dda {

struct Resultants {
  std::vector<Resultant> of;          // one a body
  std::vector<std::string> left_out;  // loads whose history is not constant, in words
};

// `acceleration` (m/s2) acts on all mass besides gravity, as the pseudo-static force of shaking does. Loads count when
// they are constant in time.
Resultants resultants_on(const std::vector<RockBody>& bodies, const Model& model, const Vec2& acceleration);

}  // namespace dda
