#include "engine/simulation/penetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/closure.h"
#include "engine/contact/contact_sharing.h"
#include "engine/core/parallel.h"

namespace dda {

namespace {

void note(const ContactSet& contacts, const BlockTerms& terms, const State& state, std::size_t first, std::size_t last,
          Penetration& deepest) {
  for (std::size_t i = first; i < last; ++i) {
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

}  // namespace

void note_penetrations(const ContactSet& contacts, const BlockTerms& terms, const State& state, Penetration& deepest) {
  const auto take_deeper = [](Penetration& one, const Penetration& other) {
    if (other.share > one.share) one = other;
  };
  const Penetration before = deepest;
  parallel_accumulate(contacts.elements.size(), contacts_of_plain_sum, deepest, before, take_deeper,
                      [&](std::size_t first, std::size_t last, Penetration& there) {
                        note(contacts, terms, state, first, last, there);
                      });
}

}  // namespace dda
