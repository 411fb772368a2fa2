#include "engine/simulation/bonded_joints.h"

#include <limits>

#include "engine/contact/contact_set.h"

namespace dda {

Vec4 bonded_force(const BlockSystem& system, const Eigen::VectorXd& increment, std::size_t i, const Vec4& gap) {
  const auto stress = [&](int block) -> Vec3 {
    const auto b = static_cast<std::size_t>(block);
    return system.state.stress[b] + system.terms.elasticity[b] * increment.segment<3>(6 * block + 3);
  };
  const InterfaceElement& element = system.contacts.elements.own()[i];
  return elastic_force(element, gap, stress(element.block_a), stress(element.block_b));
}

std::array<bool, 2> ends_that_break(const BlockSystem& system, const Eigen::VectorXd& increment, std::size_t i) {
  const ContactSet& contacts = system.contacts;
  const Vec4 gap = contacts.states[i].gap + gap_increment(contacts.elements.own()[i], increment);
  EndStrength strength = contacts.strengths[i];
  if (system.stage().unlimited_strength) {
    if (strength.tension > 0 || strength.cohesion > 0) return {false, false};
    strength.cohesion = std::numeric_limits<double>::infinity();  // closed, it sticks whatever it carries
  }
  return ends_beyond_strength(strength, bonded_force(system, increment, i, gap));
}

void accept_bonded(const std::vector<int>& bonded, BlockSystem& system) {
  for (const int index : bonded) {
    const auto i = static_cast<std::size_t>(index);
    InterfaceState& state = system.contacts.states[i];
    state.gap += gap_increment(system.contacts.elements.own()[i], system.increment);
    state.force = bonded_force(system, system.increment, i, state.gap);
  }
}

}  // namespace dda
