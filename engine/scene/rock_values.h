// Values of rock and joints that a scene and its stages give alike. They refuse, naming the field, what cannot be.
#pragma once

#include "engine/model/material.h"
#include "engine/scene/field.h"

namespace dda {

double read_poisson(const Field& field, PlaneState plane);
double read_friction_angle(const Field& field);  // rad, below a right angle
// An angle in a drawing, rad, of at most a full turn: what is beyond one is a number of degrees that lost its unit.
double read_direction(const Field& field);
// How far something turns, rad: that may be many turns, which then have their unit.
double read_angle_of_turn(const Field& field);
// The corner that a block must have not to be merged, rad: below a right angle, as no triangle and no quadrilateral has
// only corners beyond one.
double read_corner(const Field& field);

}  // namespace dda
