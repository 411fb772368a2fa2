#include "engine/simulation/height_owed.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/contact/rising_end.h"
#include "engine/simulation/block_system.h"

namespace dda {

bool owes_height(const BlockSystem& system) {
  if (!system.plan.dilation) return false;
  const ContactSet& contacts = system.contacts;
  double most_owed = 0, largest = 0;  // N per m of thickness
  for (std::size_t i = 0; i < contacts.states.size(); ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    const InterfaceState& state = contacts.states[i];
    largest = std::max(largest, state.force.cwiseAbs().maxCoeff());
    const std::array<double, 2> owed = height_owed(element, contacts.strengths[i], state);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
      if (state.status[end] != ContactStatus::open)
        most_owed = std::max(most_owed, owed[end] * element.stiffness(static_cast<Eigen::Index>(2 * end)));
  }
  return most_owed > system.stage().equilibrium * largest;
}

}  // namespace dda
