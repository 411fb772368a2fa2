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

// A projected stretch that gapes at one end presses at one place, and is shown as its other end there: told of both
// ends its force would have the open one pull.
void show_gaping_stretch(const InterfaceElement& element, const InterfaceState& state, const Interface& interface,
                         EndForces& forces, std::array<Vec2, 2>& references) {
  const bool first_gapes = state.status[0] == ContactStatus::open;
  if (element.law != InterfaceLaw::projected || first_gapes == (state.status[1] == ContactStatus::open)) return;
  const double normal = state.force(0) + state.force(2);
  if (normal == 0) return;
  const double place = element.lever * (state.force(2) - state.force(0)) / normal;  // -1 to 1 from end to end
  const std::size_t pressing = first_gapes ? 1 : 0;
  references[pressing] = (interface.from + interface.to + place * (interface.to - interface.from)) / 2;
  forces[pressing] += forces[1 - pressing];
  forces[1 - pressing].setZero();
}

}  // namespace

void append_contact_points(const Model& model, const State& blocks, const Interface& interface,
                           const InterfaceElement& element, const InterfaceState& state,
                           std::vector<ContactPoint>& points) {
  EndForces forces = end_forces(model, interface, element, state);
  std::array references = {interface.from, interface.to};
  show_gaping_stretch(element, state, interface, forces, references);
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
