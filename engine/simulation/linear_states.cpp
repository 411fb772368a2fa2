#include "engine/simulation/linear_states.h"

#include <vector>

namespace dda {

InterfaceState linear_interface_state(const BlockSystem& system, std::size_t index) {
  InterfaceElement room;
  const InterfaceElement& element = system.contacts.elements.read(index, room);
  const auto a = static_cast<std::size_t>(element.block_a);
  const auto b = static_cast<std::size_t>(element.block_b);
  const State& state = system.state;
  return linear_state(element, system.contacts.states[index].gap, state.displacement[a], state.displacement[b],
                      state.stress[a], state.stress[b]);
}

InterfaceState interface_state_now(const BlockSystem& system, std::size_t index) {
  return system.plan.linear ? linear_interface_state(system, index) : system.contacts.states[index];
}

void write_linear_states(BlockSystem& system) {
  std::vector<InterfaceState>& states = system.contacts.states;
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = linear_interface_state(system, i);
}

void sum_forces_of_states(BlockSystem& system) {
  if (!system.plan.linear) return system.sum_internal_forces(system.forces.internal_old);
  const std::vector<InterfaceState> at_rest = system.contacts.states;
  write_linear_states(system);
  system.sum_internal_forces(system.forces.internal_old);
  system.contacts.states = at_rest;
}

void keep_gap_at_rest(const State& state, const InterfaceElement& element, InterfaceState& own) {
  own.gap -= element.rows_a * state.displacement[static_cast<std::size_t>(element.block_a)] +
             element.rows_b * state.displacement[static_cast<std::size_t>(element.block_b)];
}

void keep_gaps_at_rest(BlockSystem& system) {
  ContactSet& contacts = system.contacts;
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    keep_gap_at_rest(system.state, contacts.elements.read(i, room), contacts.states[i]);
}

}  // namespace dda
