// Springs that hold a material point where it is prescribed to be.
#pragma once

#include "engine/core/types.h"

namespace dda {

// `rows` of the held point (displacement_rows), or of the way between two points of a block; `stiffness` in N/m,
// without entries in directions in which it is free.
inline Mat6 support_stiffness(const Mat26& rows, const Mat2& stiffness) { return rows.transpose() * stiffness * rows; }

}  // namespace dda
