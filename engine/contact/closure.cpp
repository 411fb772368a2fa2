#include "engine/contact/closure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/projected_law.h"

namespace dda {

bool is_open(const InterfaceElement& element, const InterfaceState& state) {
  if (has_stress_rows(element)) return false;
  const bool second_open = is_lone_vertex(element) || state.status[1] == ContactStatus::open;
  return state.status[0] == ContactStatus::open && second_open;
}

double penetration_depth(const InterfaceElement& element, const Vec4& gap, const std::vector<Vec3>& stress) {
  if (element.law == InterfaceLaw::projected)
    return projected_depth(element, gap, stress[static_cast<std::size_t>(element.block_a)],
                           stress[static_cast<std::size_t>(element.block_b)]);
  if (has_stress_rows(element)) return std::abs(gap(2)) - gap(0);
  return is_lone_vertex(element) ? -gap(0) : -std::min(gap(0), gap(2));
}

}  // namespace dda
