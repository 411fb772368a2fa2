// How a body begins to move as a whole, without turning, when its neighbours stand still (Goodman and Shi 1985).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/keyblocks/joint_face.h"

namespace dda {

// rad, or m of closing for each m of way: faces that close by less are along the way. A joint of 10 m gives way by a
// micrometre.
inline constexpr double along_the_way = 1e-7;

// Whether the body can go this way, any vector but zero, without being pressed into a neighbour.
bool permits(std::span<const JointFace> faces, const Vec2& way);

// Whether there is any way that it can go.
bool is_removable(std::span<const JointFace> faces);

// The ways that it can go: counter-clockwise from one to the other, rad. The same twice where there is one way only;
// all around for a body that touches nothing. Two ways that are opposite, as between parallel joints, come as two.
struct Ways {
  double from = 0, to = 0;
};
std::vector<Ways> permitted_ways(std::span<const JointFace> faces);

enum class Mode {
  keyed,   // there is no way that it can go
  stable,  // what acts on it presses it onto its neighbours on every way
  slides,  // along the faces it is pressed on
  falls,   // away from all its neighbours (Goodman and Shi: lifting), also upwards
};
std::string_view to_string(Mode mode);

struct FirstMotion {
  Mode mode = Mode::keyed;
  Vec2 direction = Vec2::Zero();  // unit; zero unless it slides or falls
  std::vector<int> pressed;       // faces on which it slides, indices
  double drive = 0;               // N per m of thickness, along the direction
  double resistance = 0;          // N per m of thickness, of friction and cohesion
  // Resistance over drive: infinite for what needs none.
  double factor_of_safety = 0;
};

// Under a resultant force (N per m of thickness).
FirstMotion first_motion(std::span<const JointFace> faces, const Vec2& force);

// Friction and cohesion of the faces along a way: those with the outward normal `normal` are pressed, and what presses
// is shared by length.
struct Grip {
  std::vector<int> pressed;
  double tan_friction = 0;
  double cohesion_force = 0;  // N per m of thickness
};
Grip grip_along(std::span<const JointFace> faces, const Vec2& way, const Vec2& normal);

}  // namespace dda
