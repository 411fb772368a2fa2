// What a run is asked to record: one measurement is one history, or several that belong together (quantity_names.h says
// which). Indices refer to the vectors of the model, points are as drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/types.h"

namespace dda {

enum class Quantity {
  stress_xx,
  stress_yy,
  stress_xy,     // Pa, of the block (constant in it)
  stress_1,      // Pa, the largest principal stress in the plane
  stress_2,      // Pa, the smallest
  stress_angle,  // rad, of stress_1, counter-clockwise from x, above -pi/2 up to pi/2
  mean_stress,   // Pa, half of stress_1 + stress_2
  max_shear,     // Pa, half of stress_1 - stress_2
  displacement_x,
  displacement_y,  // m, of the material point since the start
  velocity_x,
  velocity_y,  // m/s, of the material point
  acceleration_x,
  acceleration_y,  // m/s2
  rotation,        // rad, of the block since the start
  kinetic_energy,  // J per m of thickness
  traction_normal,
  traction_shear,   // Pa, mean over the interface at the point; tension positive
  bolt_force,       // N, in one bolt: axial, tension positive, the largest of its links or that of one
  bolt_shear,       // N, in one bolt: the same across it
  bolt_elongation,  // m, the sum of its links or that of one
  lining_thrust,    // N per m of thickness, in the middle of an element of a lining: compression positive
  lining_moment,    // N m per m of thickness, likewise: positive where it pulls the free face
  lining_shear,     // N per m of thickness: the slope of the moment along the wall with the rock on the left
  reaction,         // N, what supports and held blocks exert: x, y, moment
  contact_force,    // N, what `others` exert on `blocks` where they touch: x, y; normal (tension positive) and shear
  resultant,        // N, what the right of a line exerts on its left: x, y, moment
  excess_shear,  // Pa, the largest |shear| - strength of faces on a line or of a joint; m of them where it is positive
  contacts,      // of all contacts: how many are open, slide and stick; passes of the step; deepest penetration
};

struct Measurement {
  std::string name;
  Quantity quantity = Quantity::stress_xx;
  int block = 0;         // for a traction: one of the two blocks
  int other_block = -1;  // for a traction: the other block
  Vec2 point = Vec2::Zero();
  int bolt = -1;     // for quantities of bolts
  int link = -1;     // one of its links; -1: all
  int lining = -1;   // for quantities of linings
  int element = -1;  // one of its elements; -1: that in which the quantity is largest in magnitude

  // In ascending order. Quantities of blocks are the mean (energies the sum) over these in place of `block` at `point`;
  // reactions are those of these held blocks; and these are what a contact force acts on.
  std::vector<int> blocks = {};
  std::vector<int> others = {};    // of contact forces: what exerts them; ascending, none of `blocks`
  std::vector<int> supports = {};  // of reactions
  bool on_line = false;            // contact forces and excess shear: only of contacts drawn on the line below
  Vec2 from = Vec2::Zero();        // of resultants and of contacts on a line: its ends
  Vec2 to = Vec2::Zero();
  Vec2 about = Vec2::Zero();  // of moments; does not move

  // Excess shear is that of this joint alone (-1: of all), by the strength given here in place of each joint's own.
  int joint = -1;
  std::optional<double> friction_angle = {};  // rad
  std::optional<double> cohesion = {};        // Pa
};

}  // namespace dda
