#include "engine/contact/renew_springs.h"

#include <cstddef>

#include "engine/contact/make_element.h"

namespace dda {

void renew_springs(const Model& model, const Interface& interface, bool gaps_are_measured, InterfaceElement& element,
                   InterfaceState& own) {
  if (element.law != InterfaceLaw::classical) return;
  const InterfaceElement renewed = make_element(model, interface, InterfaceLaw::classical);
  for (Eigen::Index row = 0; row < 2 * ends_of(element); ++row) {
    if (renewed.stiffness(row) == element.stiffness(row) || own.force(row) == 0) continue;
    const double before = own.gap(row);
    own.gap(row) = own.force(row) / renewed.stiffness(row);
    const bool is_normal = row % 2 == 0;
    if (is_normal && gaps_are_measured && is_lone_vertex(element))
      own.seat[static_cast<std::size_t>(row / 2)] += before - own.gap(row);
  }
  element.stiffness = renewed.stiffness;
  element.dashpot = renewed.dashpot;
}

}  // namespace dda
