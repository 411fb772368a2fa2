// What a wave meets besides the rock that it is foretold in: what is held there, what absorbs, and rock that is
// missing. What lies at the far end belongs to the scene, as what that end sends back does.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/advice/acting_place.h"
#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// Share of a wave that what holds or absorbs on its way may take without a word.
inline constexpr double hardly_held = 1e-3;

struct PassingWave {
  Vec2 direction = Vec2::UnitX();  // unit, of its way
  Vec2 particles = Vec2::UnitX();  // unit, of their motion
  double frequency = 0;            // Hz, its main one
  double width = 0;                // m, of the rock across its way
};

struct Hindrance {
  std::string clause;  // for people
  ActingPlace place;
  double share = 0;  // of the wave that it sends back or takes, where that is little; at most 1
};

// Supports and blocks that stand still and hold particles, and edges along the way that absorb them, in this stage.
std::vector<Hindrance> holding_or_absorbing(const Model& model, std::size_t stage, const PassingWave& wave);

// Blocks that are drawn and not there in this stage.
std::vector<Hindrance> missing_blocks(const Model& model, std::size_t stage, const Vec2& direction);

// Blocks with faces that touch nothing, other than on the four sides of the box along `direction` and across it around
// all blocks. `drawn`: the joints as drawn.
std::vector<Hindrance> free_faces_inside(const Model& model, const ContactSet& drawn, const Vec2& direction);

// m, how far a wave goes from `front` (m along `direction`) to a place and from there to `seen`.
double way_over(const Model& model, const ActingPlace& place, const Vec2& direction, double front, const Vec2& seen);

}  // namespace dda
