// Scenes that are drawn far from the origin, as with coordinates of a national grid: what joints close by is then lost
// in the last digits of the places of blocks.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// How coarse coordinates are over what the springs of joints are pressed in by.
//
// A double holds 53 bits, so corners at X lie on a grid of about eps X, eps = 2.2e-16: 1e-9 m at 5e6 m. A joint under
// the normal stress s closes by delta = s l / k, l being the length that a spring of the stiffness k stands for; with
// the default springs of 10 E, s l / (10 E). The gap of a contact is the difference of two such places, and its force
// is wrong by the share eps X / delta. The stress is taken as half the weight of the scene's height, or the largest
// that is in the rock at the start or pulls at an edge, where that is more. 0 where there is none of these, and where
// places of blocks make no gaps, as in small kinematics and with bonded joints alone.
double coarseness_of_places(const Model& model, const ContactSet& contacts);

// Above this a remark is made. Of walls of bricks (E = 1 and 50 GPa, moved to 1e4 ... 1e8 m) settlements changed by up
// to 26 times the share, most of them by less than 8 times; how bricks slip and turn, of which there is little, changed
// by 15 to 40 times. At 0.01 the first few per cent are lost.
inline constexpr double tolerated_coarseness = 0.01;

// A sentence with the shift that helps, or nothing.
std::vector<std::string> far_coordinates(const Model& model, const ContactSet& contacts);

}  // namespace dda
