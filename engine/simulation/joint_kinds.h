// For tests: one joint of every kind that blocks which come and go may have.
#pragma once

#include <vector>

#include "engine/simulation/simulation_models.h"

namespace dda {

inline JointMaterial dry(double friction_angle) {
  JointMaterial joint;
  joint.friction_angle = friction_angle;
  return joint;
}

// Some break in the walls of these tests.
inline JointMaterial with_strength() {
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  joint.friction_angle = 0.6;
  joint.cohesion = joint.tensile_strength = 2e4;
  return joint;
}

inline JointMaterial projected(JointMaterial joint) {
  joint.law = InterfaceLaw::projected;
  return joint;
}

inline std::vector<JointMaterial> joints_of_every_kind() {
  return {bond(InterfaceLaw::consistent),
          bond(InterfaceLaw::classical),
          bond(InterfaceLaw::cubic),
          strong(InterfaceLaw::consistent),
          with_strength(),
          dry(0.6),
          projected(dry(0.6)),
          projected(with_strength())};
}

}  // namespace dda
