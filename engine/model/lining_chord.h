// Where the elements of a lining lie, as drawn.
#pragma once

#include <cstddef>

#include "engine/model/lining.h"

namespace dda {

// From the start of an element to its end, m.
inline Vec2 chord_of(const Lining& lining, std::size_t element) {
  return lining.end_of(element).point - lining.start_of(element).point;
}

inline Vec2 middle_of(const Lining& lining, std::size_t element) {
  return (lining.start_of(element).point + lining.end_of(element).point) / 2;
}

}  // namespace dda
