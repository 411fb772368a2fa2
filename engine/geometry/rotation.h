// Finite rotation and the deformation of one step.
#pragma once

#include <cmath>

#include "engine/core/types.h"

namespace dda {

// Counter-clockwise rotation by `angle` (rad).
Mat2 rotation(double angle);

// Deformation gradient of one step whose strains are measured in the directions that the block has when it has turned
// by `before` (rad): R(r0 - before) (I + E + E^2/2) R(before), E = [[ex, gxy/2], [gxy/2, ey]]. Strains in directions
// that turn with the block are the increments of one symmetric tensor, whatever moment of the step shows them.
Mat2 deformation_increment(const Vec6& dofs, double before);

// The same in the directions of the middle of the step: R(r0/2) (I + E + E^2/2) R(r0/2). It is the exponential of the
// step's displacement gradient to second order, so that a step and the same step back leave a block as it was to fourth
// order, and many small steps there and back do as well; a pure rotation keeps every length. Shi's first-order update,
// I + gradient, grows the area with 1 + r0^2. A point moves to centroid + (u0, v0) + F (point - centroid).
Mat2 deformation_increment(const Vec6& dofs);

// The components (xx, yy, xy) of a stress in a body turned counter-clockwise by `angle` (rad): R s R^T.
inline Vec3 rotate_stress(const Vec3& stress, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double shear = 2 * c * s * stress[2];
  return {c * c * stress[0] + s * s * stress[1] - shear, s * s * stress[0] + c * c * stress[1] + shear,
          c * s * (stress[0] - stress[1]) + (c * c - s * s) * stress[2]};
}

// The same of strains or their rates (ex, ey, gxy), whose third component is twice that of the tensor.
inline Vec3 rotate_strain(const Vec3& strain, double angle) {
  const Vec3 turned = rotate_stress({strain[0], strain[1], strain[2] / 2}, angle);
  return {turned[0], turned[1], 2 * turned[2]};
}

}  // namespace dda
