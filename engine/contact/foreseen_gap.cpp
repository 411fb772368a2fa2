#include "engine/contact/foreseen_gap.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/point_kinematics.h"

namespace dda {
namespace {

// The force of the start stays that of the gap as it is. What is foreseen alone neither makes an open contact press
// nor pulls one that presses apart: the step finds out. (A gap of 0 is open. A new contact begins there without shear:
// if it were taken to press it would be taken to stick as well, however fast it slides.)
void shift_normal_gap(double by, InterfaceState& state) {
  double& gap = state.gap(0);
  gap = gap >= 0 ? std::max(0.0, gap + by) : std::min(0.0, gap + by);
}

// An end that closes in the step begins without shear, so what an open one is off by means nothing.
void shift_shear_gap(double by, InterfaceState& state) {
  if (state.status[0] != ContactStatus::open) state.gap(1) += by;
}

}  // namespace

void foresee_gaps(const std::vector<Vec6>& velocity, double dt, double acts_at, ContactSet& contacts) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    if (!is_lone_vertex(element)) continue;
    const Vec6 of_a = dt * velocity[static_cast<std::size_t>(element.block_a)];
    const Vec6 of_b = dt * velocity[static_cast<std::size_t>(element.block_b)];
    const Vec2 by = (0.5 - acts_at) * PointKinematics(element).gap_change(of_a, of_b);
    shift_normal_gap(by(0), contacts.states[i]);
    shift_shear_gap(by(1), contacts.states[i]);
  }
}

}  // namespace dda
