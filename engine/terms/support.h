// Springs that hold a material point where it is prescribed to be.
#pragma once

#include "dda/core/types.h"

namespace dda {

// Stiffness (N/m) of the point, without entries in directions in which it is free.
inline Mat6 support_stiffness(const Vec2& offset, const Mat2& stiffness) {
  const Mat26 rows = displacement_rows(offset);
  return rows.transpose() * stiffness * rows;
}

}  // namespace dda
