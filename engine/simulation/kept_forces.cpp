#include "engine/simulation/kept_forces.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/simulation/block_system.h"

namespace dda {
namespace {

// Interfaces whose gaps are measured. Those that can open or slide take the mean of what their springs do from gap to
// gap where contacts conserve energy, whatever the force was that they began with.
bool is_measured(const BlockSystem& system, const InterfaceElement& element) {
  if (element.law != InterfaceLaw::consistent && element.law != InterfaceLaw::projected) return false;
  return !system.stage_in_force().integrator.conserves_contact_energy || !can_open_or_slide(element);
}

Vec2 spring_of(const SupportElement& support) { return support.stiffness * support.gap; }

// Of a link or of an element of a lining, forces of both ends on their blocks.
template <typename Element, typename Force>
void add_to_both(const Element& element, const Force& force, Eigen::VectorXd& sum) {
  sum.segment<6>(6 * element.block_a).noalias() += element.rows.a.transpose() * force;
  sum.segment<6>(6 * element.block_b).noalias() += element.rows.b.transpose() * force;
}

}  // namespace

void KeptForces::note(const BlockSystem& system) {
  if (is_noted_ || system.coefficients.load_old == 0) return;
  is_noted_ = true;
  const ContactSet& contacts = system.contacts;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    const InterfaceState& state = contacts.states[i];
    if (is_measured(system, contacts.elements.but_for_blocks(i)))
      interfaces_.push_back({interface.block_a, interface.block_b, interface.from, state.force, state.gap});
  }
  for (const SupportElement& support : system.supports) supports_.push_back(spring_of(support));
  for (const LinkElement& link : system.reinforcement.bolts.links()) links_.push_back(link.state.force);
  for (const LiningElement& element : system.reinforcement.linings.elements()) linings_.push_back(element.force());
}

// Stretches can have ended since, in the order of those that go on.
void KeptForces::compare(const BlockSystem& system) {
  if (!is_noted_) return;
  jump_.setZero(static_cast<Eigen::Index>(6 * system.model.blocks.size()));
  const ContactSet& contacts = system.contacts;
  auto noted = interfaces_.begin();
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!is_measured(system, contacts.elements.but_for_blocks(i))) continue;
    const auto is_it = [&](const OfInterface& each) {
      return each.block_a == interface.block_a && each.block_b == interface.block_b && each.from == interface.from;
    };
    noted = std::find_if(noted, interfaces_.end(), is_it);
    if (noted == interfaces_.end()) break;
    const InterfaceState& state = contacts.states[i];
    add_interface_force(contacts.elements.read(i, room), state.force - noted->force, state.gap - noted->gap, jump_);
  }
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const SupportElement& support = system.supports[i];
    jump_.segment<6>(6 * support.block).noalias() += support.rows.transpose() * (spring_of(support) - supports_[i]);
  }
  const std::span<const LinkElement> links = system.reinforcement.bolts.links();
  for (std::size_t i = 0; i < links_.size(); ++i) add_to_both(links[i], links[i].state.force - links_[i], jump_);
  const std::span<const LiningElement> linings = system.reinforcement.linings.elements();
  for (std::size_t i = 0; i < linings_.size(); ++i) add_to_both(linings[i], linings[i].force() - linings_[i], jump_);
}

void KeptForces::forget() {
  if (!is_noted_) return;
  is_noted_ = false;
  interfaces_.clear();
  supports_.clear();
  links_.clear();
  linings_.clear();
  jump_.setZero();
}

}  // namespace dda
