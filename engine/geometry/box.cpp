#include "engine/geometry/box.h"

namespace dda {

Box bounding_box(const Ring& ring) {
  Box box;
  for (const Vec2& vertex : ring) box = expanded(box, vertex);
  return box;
}

}  // namespace dda
