#include "engine/contact/make_element.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

Vec4 classical_stiffness(const Model& model, const Interface& interface) {
  const Springs springs = springs_of(model, interface);
  const double second_point = interface.length > 0 ? 1 : 0;
  return {springs.normal, springs.shear, second_point * springs.normal, second_point * springs.shear};
}

// The stiffer of both blocks' moduli, Pa.
double stiffer(const Model& model, const Interface& interface, double (*modulus)(const Material&)) {
  return std::max(modulus(model.material_at_start(interface.block_a)),
                  modulus(model.material_at_start(interface.block_b)));
}

// What the rows need that do not resist a change of volume, Pa: the plane modulus, but no more than four times the
// shear modulus, which it exceeds in plane strain beyond nu = 1/3. Pressure does not shear a joint, so its stiffness
// has no place in the tangential rows; and the difference of the normal gaps at the ends, held with the stiffness of
// the volume, would lock nearly incompressible meshes (Hansbo & Larson 2002 project the jump for the same reason).
double isochoric_modulus(const Material& material) {
  const Mat3 elasticity = elasticity_matrix(material);
  return std::min(elasticity(0, 0), 4 * elasticity(2, 2));
}

// Nitsche's penalty: the stiffer modulus over the smaller width, so that the bound on `penalty` holds for both blocks.
// Beside a held block all of the other's stress acts on the gap and not half of it, which asks for twice the penalty.
Vec4 consistent_stiffness(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  const double across = std::min(width_across(model, interface.block_a, interface.normal),
                                 width_across(model, interface.block_b, interface.normal));
  const double share = std::max(stress_share(model, interface.block_a, interface.block_b),
                                stress_share(model, interface.block_b, interface.block_a));
  const double unit = 2 * share * interface.length / across;
  const double volume = unit * stiffer(model, interface, plane_modulus);
  const double shear = unit * stiffer(model, interface, isochoric_modulus);
  const double ends = stabilisation_of(joint) * shear;
  return {joint.penalty * volume, joint.penalty * shear, ends, ends};
}

// Stiffness of the cubic law: rows 0 and 2 from the reconstruction, 1 by Nitsche's penalty, and on 3 the bending
// stiffness E I/L that two constant-strain blocks lack.
Vec4 cubic_stiffness(const Model& model, const Interface& interface) {
  const double half = cubic_half_distance(model, interface);
  const double unit = side_free_modulus(model.material_of(interface.block_a)) * interface.length / half;
  return {cubic::gap_stiffness * unit, consistent_stiffness(model, interface)(1), cubic::jump_stiffness * unit,
          cubic::bending_stiffness * unit};
}

Mat46 rows_of(const Mat2& axes, const Vec2& from, const Vec2& to, const Vec2& centroid, InterfaceLaw law) {
  const Mat26 first = local_rows(axes, from - centroid);
  const Mat26 last = local_rows(axes, to - centroid);
  Mat46 rows;
  switch (law) {
    case InterfaceLaw::classical:
    case InterfaceLaw::projected: rows << first, last; break;
    case InterfaceLaw::consistent: rows << (first + last) / 2, (last - first) / 2; break;
    case InterfaceLaw::cubic:
      rows << (first + last) / 2, ((from + to) / 2 - centroid).norm() * strain_along(axes.row(0)).transpose(),
          (last.row(0) - first.row(0)) / 2;
      break;
  }
  return rows;
}

// sigma_nn over the components (xx, yy, xy).
Eigen::RowVector3d normal_stress_row(const Vec2& n) { return {n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y()}; }

// The stress rows of a block on the a side (side = 1) or b side (side = -1).
Mat43 stress_rows(const Mat2& axes, double length, InterfaceLaw law, double side, double share,
                  const Material& material) {
  Mat43 rows = Mat43::Zero();
  const Vec2 n = axes.row(0);
  rows.topRows<2>() = share * length * axes * traction_rows(n);
  if (law == InterfaceLaw::consistent) return rows;
  const Vec2 side_direction = axes.row(1);
  const Eigen::RowVector3d axial = normal_stress_row(n) - side_free_ratio(material) * normal_stress_row(side_direction);
  rows.row(0) = length / 2 * axial;
  rows.row(2) = side * cubic::jump_traction * length * axial;
  return rows;
}

// Stiffness (N/m) of the four rows under a law that is not projected; see JointMaterial for the parameters.
Vec4 interface_stiffness(const Model& model, const Interface& interface, InterfaceLaw law) {
  if (law == InterfaceLaw::classical) return classical_stiffness(model, interface);
  return law == InterfaceLaw::consistent ? consistent_stiffness(model, interface) : cubic_stiffness(model, interface);
}

}  // namespace

double stress_share(const Model& model, int block, int other) {
  const bool own = model.is_held(block);
  if (own == model.is_held(other)) return 0.5;
  return own ? 0 : 1;
}

InterfaceElement make_element(const Model& model, const Interface& interface, InterfaceLaw law) {
  InterfaceElement element;
  element.block_a = interface.block_a;
  element.block_b = interface.block_b;
  element.law = law;
  element.length = interface.length;
  if (law == InterfaceLaw::projected)
    set_projected_springs(model, interface, element);
  else
    element.stiffness = interface_stiffness(model, interface, law);
  const double damping = model.joints[static_cast<std::size_t>(interface.joint)].contact_damping;
  if (damping > 0 && (law == InterfaceLaw::classical || law == InterfaceLaw::projected)) {
    const double mass = std::min(model.mass_of(interface.block_a), model.mass_of(interface.block_b));
    element.dashpot = 2 * damping * (element.stiffness * mass).cwiseSqrt();
  }
  return element;
}

void set_geometry(const Model& model, const InterfaceFrame& frame, InterfaceElement& element) {
  if (element.law == InterfaceLaw::projected) {
    set_projected_rows(model, frame, element);
    return;
  }
  const Mat2 axes = local_axes(frame.normal);
  element.rows_a = -rows_of(axes, frame.from_a, frame.to_a, frame.centroid_a, element.law);
  element.rows_b = rows_of(axes, frame.from_b, frame.to_b, frame.centroid_b, element.law);
  if (!has_stress_rows(element)) return;
  const Material& material_a = model.material_of(element.block_a);
  const Material& material_b = model.material_of(element.block_b);
  const double share_a = stress_share(model, element.block_a, element.block_b);
  const double share_b = stress_share(model, element.block_b, element.block_a);
  element.stress_rows_a = stress_rows(axes, element.length, element.law, 1, share_a, material_a);
  element.stress_rows_b = stress_rows(axes, element.length, element.law, -1, share_b, material_b);
  element.strain_rows_a = element.stress_rows_a * elasticity_matrix(material_a);
  element.strain_rows_b = element.stress_rows_b * elasticity_matrix(material_b);
}

}  // namespace dda
