#include "engine/simulation/contact_work.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/contact_set.h"

namespace dda {
namespace {

bool opens(const InterfaceState& before, const InterfaceState& after) {
  const auto ends_open = [](const InterfaceState& state) {
    return std::ranges::count(state.status, ContactStatus::open);
  };
  return ends_open(after) > ends_open(before);
}

double longest_slip(const InterfaceState& before, const InterfaceState& after) {
  return std::max(std::abs(after.slip[0] - before.slip[0]), std::abs(after.slip[1] - before.slip[1]));
}

double share_of(double part, double all) { return all != 0 ? std::clamp(part / all, 0.0, 1.0) : 0; }

}  // namespace

// A spring that is let go within the step gives what it has stored. Its mean force over the step would do work on all
// the way that a held block goes, most of it far from what it has left: nothing has gained that.
void ContactWork::changed(const InterfaceElement& element, const InterfaceState& before, const InterfaceState& after,
                          const GapChange& gap_change, const WorkingForces& forces) {
  // What the balance of the step had of the contact: springs and dashpots together, and under steps that conserve
  // energy another mean than that of the springs at both ends of the step.
  const Vec4 borne = (before.force + after.force) / 2 + forces.extra;
  const double work = gap_change.all.dot(borne);
  const Vec4 dashpot_force = (1 - forces.dashpot_delay) * after.dashpot + forces.dashpot_delay * before.dashpot;
  double by_dashpot = gap_change.all.dot(dashpot_force);
  double by_friction = 0, by_rise = 0;
  for (std::size_t end = 0; end < 2; ++end) {
    const auto normal_row = static_cast<Eigen::Index>(2 * end), shear_row = normal_row + 1;
    // Where a step turns the slip round, the mean force may point against it: that is no friction.
    if (const double slip = after.slip[end] - before.slip[end]; slip != 0) {
      by_friction += std::max(0.0, borne(shear_row) * slip);
      by_dashpot -= dashpot_force(shear_row) * slip;
    }
    // What sliding up its own slope gives back against the normal force is no loss.
    if (const double rise = after.dilation[end] - before.dilation[end]; rise != 0)
      by_rise += (borne(normal_row) - after.dashpot(normal_row)) * rise;
  }
  const double slip = longest_slip(before, after);
  by_friction = std::min(by_friction, forces.most_friction * slip);
  if (slip > 0) friction_beyond_end += std::max(0.0, by_friction - forces.friction_at_end * slip);
  by_friction += by_rise;
  const double stored = interface_energy(element, after) - interface_energy(element, before);
  friction += by_friction;
  dashpot += by_dashpot;
  const double off = work - stored - by_friction - by_dashpot;
  const double of_held = opens(before, after) && off < 0 ? off * share_of(gap_change.held.dot(borne), work) : 0;
  brought -= of_held;
  numerical += off - of_held;
}

}  // namespace dda
