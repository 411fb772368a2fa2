#include "engine/simulation/settling_cushion.h"

#include <algorithm>
#include <cstddef>

#include "engine/simulation/block_system.h"
#include "engine/simulation/settling_pace.h"
#include "engine/solve/step_matrix.h"

namespace dda {
namespace {

// The share of normal stiffness in a step as long as the first, and at most: more than the springs themselves brings
// nothing but round-off.
constexpr double firmness = 0.3;
constexpr double firmest = 3;
constexpr int most_steps = 100;

double share_of_stiffness(const BlockSystem& system) {
  const double length = system.coefficients.dt / first_step(system.model, system.stage(), system.contacts.can_change);
  return std::min(firmness / (length * length), firmest);
}

// 1 in the normal rows of ends without a bond that touch.
Vec4 cushioned_rows(const BlockSystem& system, std::size_t contact) {
  const InterfaceState& state = system.contacts.states[contact];
  Vec4 rows = Vec4::Zero();
  for (const int end : {0, 1})
    if (state.broken[static_cast<std::size_t>(end)] && state.gap(2 * end) <= system.model.length_tolerance)
      rows(2 * end) = 1;
  return rows;
}

}  // namespace

bool SettlingCushion::put_in(const BlockSystem& system) {
  if (was_put_in_ || !system.stage().paces_itself()) return false;
  was_put_in_ = true;
  steps_left_ = most_steps;
  return true;
}

void SettlingCushion::add_to(const BlockSystem& system, std::span<const int> contacts, BlockMatrix& matrix) const {
  if (!is_in()) return;
  const double share = share_of_stiffness(system);
  for (const int contact : contacts) {
    const auto i = static_cast<std::size_t>(contact);
    add_contact(share, system.contacts.elements.own()[i], {cushioned_rows(system, i), 0}, true, true, matrix);
  }
}

double SettlingCushion::work(const BlockSystem& system, std::span<const int> contacts) const {
  if (!is_in()) return 0;
  double work = 0;
  for (const int contact : contacts) {
    const auto i = static_cast<std::size_t>(contact);
    const InterfaceElement& element = system.contacts.elements.own()[i];
    const Vec4 change = gap_increment(element, system.increment);
    const Vec4 force = cushioned_rows(system, i).cwiseProduct(element.stiffness).cwiseProduct(change);
    work += force.dot(system.held.empty() ? change : change - system.held.gap_increment(element));
  }
  return share_of_stiffness(system) * work;
}

}  // namespace dda
