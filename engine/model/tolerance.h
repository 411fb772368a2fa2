// How far points given from outside may lie off the block they are meant for.
#pragma once

#include "engine/model/model.h"

namespace dda {

// m. Looser than length_tolerance, because coordinates of loads and measuring points are often written with six or
// seven digits; what is decided with it (which block, which edge) does not enter the mechanics.
inline double point_tolerance(const Model& model) { return 100 * model.length_tolerance; }

// A gap wider than this share of the smaller block beside it is air and no open joint: contacts are sought no farther.
inline constexpr double widest_joint = 0.1;

}  // namespace dda
