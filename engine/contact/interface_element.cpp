#include "engine/contact/interface_element.h"

#include "engine/contact/block_across.h"

namespace dda {

Mat2 local_axes(const Vec2& normal) { return (Mat2() << normal.x(), normal.y(), -normal.y(), normal.x()).finished(); }

// axes * displacement_rows(offset), written out: finite kinematics need it for every interface at every step.
Mat26 local_rows(const Mat2& axes, const Vec2& offset) {
  const double x = offset.x();
  const double y = offset.y();
  Mat26 rows;
  for (int i = 0; i < 2; ++i) {
    const double ax = axes(i, 0);
    const double ay = axes(i, 1);
    rows.row(i) << ax, ay, ay * x - ax * y, ax * x, ay * y, (ax * y + ay * x) / 2;
  }
  return rows;
}

InterfaceFrame reference_frame(const Model& model, const Interface& interface) {
  return {interface.from,
          interface.to,
          interface.from,
          interface.to,
          interface.normal,
          block_of(model, interface.block_a).moments.centroid,
          block_of(model, interface.block_b).moments.centroid};
}

}  // namespace dda
