#include "engine/simulation/measured_anew.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace dda {
namespace {

// Interfaces whose gaps are measured. Those that can open or slide take the mean of what their springs do from gap to
// gap where contacts conserve energy, whatever the force was that they began with.
bool is_measured(const BlockSystem& system, const InterfaceElement& element) {
  if (element.law != InterfaceLaw::consistent && element.law != InterfaceLaw::projected) return false;
  return !system.stage_in_force().integrator.conserves_contact_energy || !can_open_or_slide(element);
}

Vec2 spring_of(const SupportElement& support) { return support.stiffness * support.gap; }

// What a link, or an element of a lining, does to both of its blocks.
template <typename Element, typename Force>
void add_to_both(const Element& element, const Force& force, Eigen::VectorXd& sum) {
  sum.segment<6>(6 * element.block_a).noalias() += element.rows.a.transpose() * force;
  sum.segment<6>(6 * element.block_b).noalias() += element.rows.b.transpose() * force;
}

// Stretches can have ended since they were noted; those that go on are in the same order.
void add_jump_of_interfaces(const BlockSystem& system, KeptForces& kept) {
  const ContactSet& contacts = system.contacts;
  auto noted = kept.interfaces.begin();
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!is_measured(system, contacts.elements.but_for_blocks(i))) continue;
    const auto is_it = [&](const KeptForces::OfInterface& each) {
      return each.block_a == interface.block_a && each.block_b == interface.block_b && each.from == interface.from;
    };
    noted = std::find_if(noted, kept.interfaces.end(), is_it);
    if (noted == kept.interfaces.end()) return;
    const InterfaceState& state = contacts.states[i];
    add_interface_force(contacts.elements.read(i, room), state.force - noted->force, state.gap - noted->gap, kept.jump);
  }
}

}  // namespace

void note_forces(BlockSystem& system) {
  KeptForces& kept = system.forces.kept;
  if (kept.are_noted || system.coefficients.load_old == 0) return;
  kept.are_noted = true;
  const ContactSet& contacts = system.contacts;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    const InterfaceState& state = contacts.states[i];
    if (is_measured(system, contacts.elements.but_for_blocks(i)))
      kept.interfaces.push_back({interface.block_a, interface.block_b, interface.from, state.force, state.gap});
  }
  for (const SupportElement& support : system.supports) kept.supports.push_back(spring_of(support));
  for (const LinkElement& link : system.reinforcement.bolts.links()) kept.links.push_back(link.state.force);
  for (const LiningElement& element : system.reinforcement.linings.elements()) kept.linings.push_back(element.force());
}

void compare_forces(BlockSystem& system) {
  KeptForces& kept = system.forces.kept;
  if (!kept.are_noted) return;
  kept.jump.setZero(static_cast<Eigen::Index>(6 * system.model.blocks.size()));
  add_jump_of_interfaces(system, kept);
  for (std::size_t i = 0; i < kept.supports.size(); ++i) {
    const SupportElement& support = system.supports[i];
    const Vec2 more = spring_of(support) - kept.supports[i];
    kept.jump.segment<6>(6 * support.block).noalias() += support.rows.transpose() * more;
  }
  const std::span<const LinkElement> links = system.reinforcement.bolts.links();
  for (std::size_t i = 0; i < kept.links.size(); ++i)
    add_to_both(links[i], links[i].state.force - kept.links[i], kept.jump);
  const std::span<const LiningElement> linings = system.reinforcement.linings.elements();
  for (std::size_t i = 0; i < kept.linings.size(); ++i)
    add_to_both(linings[i], linings[i].force() - kept.linings[i], kept.jump);
}

}  // namespace dda
