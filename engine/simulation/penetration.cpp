#include "engine/simulation/penetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/projected_law.h"

namespace dda {

double penetration_depth(const InterfaceElement& element, const Vec4& gap, const std::vector<Vec3>& stress) {
  if (element.law == InterfaceLaw::projected)
    return projected_depth(element, gap, stress[static_cast<std::size_t>(element.block_a)],
                           stress[static_cast<std::size_t>(element.block_b)]);
  if (has_stress_rows(element)) return std::abs(gap(2)) - gap(0);
  return element.length > 0 ? -std::min(gap(0), gap(2)) : -gap(0);
}

void note_penetrations(const ContactSet& contacts, const BlockTerms& terms, const State& state, Penetration& deepest) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    const double depth = penetration_depth(element, contacts.states[i].gap, state.stress);
    const double area = std::min(terms.area[static_cast<std::size_t>(element.block_a)],
                                 terms.area[static_cast<std::size_t>(element.block_b)]);
    if (depth <= 0 || depth * depth <= deepest.share * deepest.share * area) continue;
    deepest.depth = depth;
    deepest.share = depth / std::sqrt(area);
    deepest.block_a = element.block_a;
    deepest.block_b = element.block_b;
    deepest.time = state.time;
  }
}

}  // namespace dda
