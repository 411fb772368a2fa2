// Springs that hold a material point where it is prescribed to be.
#pragma once

#include "dda/core/types.h"

namespace dda {

// Stiffness (N/m) in x and y; zero where the point is free.
inline Mat6 support_stiffness(const Vec2& offset, const Vec2& stiffness) {
  const Mat26 rows = displacement_rows(offset);
  return rows.transpose() * stiffness.asDiagonal() * rows;
}

}  // namespace dda
