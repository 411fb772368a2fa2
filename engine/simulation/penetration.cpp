#include "engine/simulation/penetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/closure.h"

namespace dda {

void note_penetrations(const ContactSet& contacts, const BlockTerms& terms, const State& state, Penetration& deepest) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
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
