#include "engine/simulation/settling_cushion.h"

#include <cstddef>

#include "engine/simulation/block_system.h"
#include "engine/solve/step_matrix.h"

namespace dda {
namespace {

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

void add_cushions(const BlockSystem& system, std::span<const int> contacts, BlockMatrix& matrix) {
  if (system.cushion == 0) return;
  for (const int contact : contacts) {
    const auto i = static_cast<std::size_t>(contact);
    add_contact(system.cushion, system.contacts.elements[i], {cushioned_rows(system, i), 0}, true, true, matrix);
  }
}

double work_of_cushions(const BlockSystem& system, std::span<const int> contacts) {
  if (system.cushion == 0) return 0;
  double work = 0;
  for (const int contact : contacts) {
    const auto i = static_cast<std::size_t>(contact);
    const InterfaceElement& element = system.contacts.elements[i];
    const Vec4 change = gap_increment(element, system.increment);
    const Vec4 force = system.cushion * cushioned_rows(system, i).cwiseProduct(element.stiffness).cwiseProduct(change);
    work += force.dot(system.held.empty() ? change : change - system.held.gap_increment(element));
  }
  return work;
}

}  // namespace dda
