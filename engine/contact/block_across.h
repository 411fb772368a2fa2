// A block as an interface with a given normal meets it.
#pragma once

#include <cstddef>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

inline const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

// Width of a block across an interface with this normal, m. The sum of length * width over the sides of any convex
// block is about four times its area (six for a triangle), which is what bounds Nitsche's penalty from below.
inline double width_across(const Model& model, int block, const Vec2& normal) {
  return extent_along(block_of(model, block).shape.outer, normal);
}

// Stress over strain in a wave that strains along its way alone, as P waves do, Pa.
inline double plane_modulus(const Material& material) { return elasticity_matrix(material)(0, 0); }

// The traction on a plane by the components (xx, yy, xy) of the stress.
inline Eigen::Matrix<double, 2, 3> traction_rows(const Vec2& normal) {
  Eigen::Matrix<double, 2, 3> rows;
  rows << normal.x(), 0, normal.y(), 0, normal.y(), normal.x();
  return rows;
}

}  // namespace dda
