#include "engine/contact/in_situ_force.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/interface_state.h"

namespace dda {

Vec4 in_situ_force(const Model& model, const Interface& interface) {
  const auto stress = [&](int block) { return model.blocks[static_cast<std::size_t>(block)].initial_stress; };
  const Vec3 mean = (stress(interface.block_a) + stress(interface.block_b)) / 2;
  const Vec2& n = interface.normal;
  const Vec2 global = interface.length / 2 * traction_on(mean, n);
  Vec2 force(n.dot(global), n.x() * global.y() - n.y() * global.x());
  const EndStrength strength = end_strength(model.joints[static_cast<std::size_t>(interface.joint)], interface.length);
  if (strength.is_dry()) {
    const double capacity = strength.capacity(force(0), false);
    force = {std::min(force(0), 0.0), std::clamp(force(1), -capacity, capacity)};
  }
  return {force(0), force(1), force(0), force(1)};
}

}  // namespace dda
