// Absorbing boundary of Lysmer & Kuhlemeyer (1969): traction = -impedance * velocity on an edge, implicit.
#pragma once

#include "engine/core/types.h"

namespace dda {

// Damping matrix C (force = -C v) of a straight edge, ends relative to the block's centroid, impedances in Pa s/m.
// The integral of T^T Z T is quadratic along the edge, so two Gauss points are exact.
Mat6 viscous_damping(const Vec2& from, const Vec2& to, double normal_impedance, double shear_impedance);

// What the same dashpots do when their far ends move with another block along its line `other_from` to `other_to`
// (relative to that block's centroid, beside the edge point for point): force = coupling * velocity of the other block.
Mat6 viscous_coupling(const Vec2& from, const Vec2& to, const Vec2& other_from, const Vec2& other_to,
                      double normal_impedance, double shear_impedance);

}  // namespace dda
