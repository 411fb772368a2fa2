#include "engine/simulation/penetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/closure.h"
#include "engine/contact/contact_sharing.h"
#include "engine/core/parallel.h"

namespace dda {

namespace {

// Outlines are asked only where the closure is deeper than what was found, as most is not.
void note(const Model& model, const ContactSet& contacts, const BlockTerms& terms, const State& state,
          std::size_t first, std::size_t last, Penetration& deepest) {
  for (std::size_t i = first; i < last; ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    const double closed = penetration_depth(element, contacts.states[i].gap, state.stress);
    const double area = std::min(terms.area[static_cast<std::size_t>(element.block_a)],
                                 terms.area[static_cast<std::size_t>(element.block_b)]);
    const auto is_deeper = [&](double depth) {
      return depth > 0 && depth * depth > deepest.share * deepest.share * area;
    };
    if (!is_deeper(closed)) continue;
    const double depth = depth_in_each_other(model, state, contacts.interfaces[i], element, contacts.states[i]);
    if (!is_deeper(depth)) continue;
    deepest.depth = depth;
    deepest.share = depth / std::sqrt(area);
    deepest.block_a = element.block_a;
    deepest.block_b = element.block_b;
    deepest.time = state.time;
  }
}

}  // namespace

void note_penetrations(const Model& model, const ContactSet& contacts, const BlockTerms& terms, const State& state,
                       Penetration& deepest) {
  const auto take_deeper = [](Penetration& one, const Penetration& other) {
    if (other.share > one.share) one = other;
  };
  const Penetration before = deepest;
  parallel_accumulate(contacts.elements.size(), contacts_of_plain_sum, deepest, before, take_deeper,
                      [&](std::size_t first, std::size_t last, Penetration& there) {
                        note(model, contacts, terms, state, first, last, there);
                      });
}

}  // namespace dda
