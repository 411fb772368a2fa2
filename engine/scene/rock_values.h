// Values of rock and joints that a scene and its stages give alike. They refuse, naming the field, what cannot be.
#pragma once

#include "engine/model/material.h"
#include "engine/scene/field.h"

namespace dda {

double read_poisson(const Field& field, PlaneState plane);
double read_friction_angle(const Field& field);  // rad, below a right angle

}  // namespace dda
