#include "engine/contact/contact_points.h"

#include <array>
#include <cstddef>

#include "engine/contact/contact_set.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

// Normal and shear force at each end.
using EndForces = std::array<Vec2, 2>;

// A middle force and the half difference of the ends' forces are what the consistent and the cubic law carry.
EndForces shared(const Vec2& middle, const Vec2& half_difference) {
  return {(middle - half_difference) / 2, (middle + half_difference) / 2};
}

EndForces end_forces(const Model& model, const Interface& interface, const InterfaceElement& element,
                     const InterfaceState& state) {
  switch (element.law) {
    case InterfaceLaw::classical: break;
    case InterfaceLaw::projected: return forces_at_ends(element, state.force);
    case InterfaceLaw::consistent: return shared(state.force.head<2>(), state.force.tail<2>());
    case InterfaceLaw::cubic:
      return shared(element.length * mean_traction(model, interface, element, state), Vec2(state.force(3), 0));
  }
  return {state.force.head<2>(), state.force.tail<2>()};
}

}  // namespace

void append_contact_points(const Model& model, const State& blocks, const Interface& interface,
                           const InterfaceElement& element, const InterfaceState& state,
                           std::vector<ContactPoint>& points) {
  const EndForces forces = end_forces(model, interface, element, state);
  const std::array references = {interface.from, interface.to};
  const std::size_t ends = interface.length > 0 ? 2 : 1;
  for (std::size_t end = 0; end < ends; ++end) {
    ContactPoint& point = points.emplace_back();
    point.block_a = interface.block_a;
    point.block_b = interface.block_b;
    point.reference = references[end];
    point.point = current_position(model, blocks, interface.block_b, references[end]);
    point.normal = normal_of(element);
    point.normal_force = forces[end](0);
    point.shear_force = forces[end](1);
    point.status = state.status[end];
  }
}

}  // namespace dda
