#include "dda/contact/interface_element.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace dda {
namespace {

const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

// Rows (normal, tangent): the local components of a global vector.
Mat2 local_axes(const Vec2& normal) {
  return (Mat2() << normal.x(), normal.y(), -normal.y(), normal.x()).finished();
}

// Width of a block across an interface with this normal. The sum of length * width over the sides of any convex block is
// about four times its area (six for a triangle), which is what bounds Nitsche's penalty from below.
double width(const Model& model, int block, const Vec2& normal) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec2& vertex : block_of(model, block).shape.outer) {
    least = std::min(least, normal.dot(vertex));
    most = std::max(most, normal.dot(vertex));
  }
  return most - least;
}

double softer_young(const Model& model, const Interface& interface) {
  return std::min(model.material_of(interface.block_a).young, model.material_of(interface.block_b).young);
}

Vec4 classical_stiffness(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  const double normal =
      joint.normal_spring > 0 ? joint.normal_spring : joint.spring_over_young * softer_young(model, interface);
  const double shear = joint.shear_to_normal * normal;
  const double second_point = interface.length > 0 ? 1 : 0;
  return {normal, shear, second_point * normal, second_point * shear};
}

// Nitsche's penalty: the stiffer modulus over the smaller width, so that the bound on `penalty` holds for both blocks.
Vec4 consistent_stiffness(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  const double modulus = std::max(elasticity_matrix(model.material_of(interface.block_a))(0, 0),
                                  elasticity_matrix(model.material_of(interface.block_b))(0, 0));
  const double across =
      std::min(width(model, interface.block_a, interface.normal), width(model, interface.block_b, interface.normal));
  const double unit = modulus * interface.length / across;
  return {joint.penalty * unit, joint.penalty * unit, joint.stabilisation * unit, joint.stabilisation * unit};
}

Mat46 rows_of(const Mat2& axes, const Vec2& from, const Vec2& to, const Vec2& centroid, InterfaceLaw law) {
  const Mat26 first = axes * displacement_rows(from - centroid);
  const Mat26 last = axes * displacement_rows(to - centroid);
  Mat46 rows;
  if (law == InterfaceLaw::classical) {
    rows << first, last;
  } else {
    rows << (first + last) / 2, (last - first) / 2;
  }
  return rows;
}

}  // namespace

InterfaceFrame reference_frame(const Model& model, const Interface& interface) {
  return {interface.from,   interface.to,
          interface.from,   interface.to,
          interface.normal, block_of(model, interface.block_a).moments.centroid,
          block_of(model, interface.block_b).moments.centroid};
}

Vec4 interface_stiffness(const Model& model, const Interface& interface, InterfaceLaw law) {
  return law == InterfaceLaw::classical ? classical_stiffness(model, interface)
                                        : consistent_stiffness(model, interface);
}

InterfaceElement make_element(const Model& model, const Interface& interface, InterfaceLaw law) {
  InterfaceElement element;
  element.block_a = interface.block_a;
  element.block_b = interface.block_b;
  element.law = law;
  element.length = interface.length;
  element.stiffness = interface_stiffness(model, interface, law);
  return element;
}

void set_geometry(const Model& model, const InterfaceFrame& frame, InterfaceElement& element) {
  const Mat2 axes = local_axes(frame.normal);
  element.rows_a = -rows_of(axes, frame.from_a, frame.to_a, frame.centroid_a, element.law);
  element.rows_b = rows_of(axes, frame.from_b, frame.to_b, frame.centroid_b, element.law);
  if (element.law == InterfaceLaw::classical) return;
  const Vec2& n = frame.normal;
  const Mat23 traction_of_stress = (Mat23() << n.x(), 0, n.y(), 0, n.y(), n.x()).finished();
  element.half_traction = element.length / 2 * axes * traction_of_stress;
  element.traction_rows_a = element.half_traction * elasticity_matrix(model.material_of(element.block_a));
  element.traction_rows_b = element.half_traction * elasticity_matrix(model.material_of(element.block_b));
}

}  // namespace dda
