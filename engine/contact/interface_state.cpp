#include "engine/contact/interface_state.h"

#include <cmath>
#include <limits>

namespace dda {

EndStrength end_strength(const JointMaterial& joint, double length) {
  const double unlimited = std::numeric_limits<double>::infinity();
  if (joint.bonded) return {unlimited, unlimited, 0};
  EndStrength strength = unbonded_strength(joint, length / 2);
  strength.tension = joint.tensile_strength * length / 2;
  strength.cohesion = joint.cohesion * length / 2;
  return strength;
}

EndStrength unbonded_strength(const JointMaterial& joint, double length) {
  const double friction = std::tan(joint.friction_angle);
  return {.friction = friction,
          .residual_cohesion = joint.residual_cohesion * length,
          .friction_drop = friction - std::tan(joint.residual_friction_angle.value_or(joint.friction_angle)),
          .dilation = std::tan(joint.dilation_angle),
          .dilation_slip = joint.zero_dilation_slip};
}

bool exceeds(const EndStrength& strength, double normal_force, double shear_force) {
  return normal_force > strength.tension ||
         std::abs(shear_force) > strength.cohesion - strength.friction * normal_force;
}

std::array<bool, 2> ends_beyond_strength(const EndStrength& strength, const Vec4& force) {
  return {exceeds(strength, (force(0) - force(2)) / 2, force(1) / 2),
          exceeds(strength, (force(0) + force(2)) / 2, force(1) / 2)};
}

Vec4 elastic_force(const InterfaceElement& element, const Vec4& gap, const Vec3& stress_a, const Vec3& stress_b) {
  Vec4 force = element.stiffness.cwiseProduct(gap);
  if (has_stress_rows(element))
    force +=
        element.stress_rows_a * stress_a + element.stress_rows_b * stress_b + element.by_loads - element.force_at_start;
  return force;
}

InterfaceState as_classical(const InterfaceState& consistent, const Vec4& classical_stiffness) {
  InterfaceState state = consistent;
  state.force << consistent.force.head<2>() - consistent.force.tail<2>(),
      consistent.force.head<2>() + consistent.force.tail<2>();
  state.force /= 2;
  for (Eigen::Index row = 0; row < 4; ++row)
    state.gap(row) = elastic_gap(state.force(row), classical_stiffness(row), 0);
  return state;
}

}  // namespace dda
