#include "dda/contact/moving_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool is_dry(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[at(interface.joint)];
  return !joint.bonded && joint.cohesion == 0 && joint.tensile_strength == 0;
}

Interface interface_of(const Model& model, const Outlines& outlines, const VertexContact& contact) {
  Interface interface;
  interface.block_a = contact.edge_block;
  interface.block_b = contact.vertex_block;
  interface.from = interface.to =
      model.blocks[at(contact.vertex_block)].moments.centroid + outlines.reference[at(contact.vertex)];
  interface.normal = contact.normal;
  interface.joint = joint_index(model, contact.edge_block, contact.vertex_block);
  return interface;
}

// Both blocks feel the contact at the vertex, so its forces have no moment between them.
InterfaceFrame frame_of(const Model& model, const State& state, const Outlines& outlines, const VertexContact& contact) {
  const Vec2& point = outlines.current[at(contact.vertex)];
  return {point,          point,
          point,          point,
          contact.normal, current_centroid(model, state, contact.edge_block),
          current_centroid(model, state, contact.vertex_block)};
}

// A dry contact is broken from the start: friction is all that it has.
InterfaceState fresh_state() {
  InterfaceState state;
  state.broken = {true, true};
  state.status = {ContactStatus::open, ContactStatus::open};
  return state;
}

void measure(const InterfaceElement& element, double gap, InterfaceState& state) {
  state.gap(0) = gap;
  if (gap > 0) {
    state.status[0] = ContactStatus::open;
    state.gap(1) = 0;
  } else if (state.status[0] == ContactStatus::open) {
    state.status[0] = ContactStatus::locked;
  }
  state.force(0) = gap > 0 ? 0 : element.stiffness(0) * gap;
  state.force(1) = element.stiffness(1) * state.gap(1);
}

}  // namespace

MovingContacts::MovingContacts(const Model& model, const State& state, ContactSet& contacts) : search_(model, state) {
  stretches_ = contacts.interfaces.size();
  drop_stretches(model, contacts, true);
  refresh(model, state, contacts);
}

bool MovingContacts::follow(const Model& model, const State& state, ContactSet& contacts) {
  const bool new_pairs = search_.update(model, state);
  drop_stretches(model, contacts, false);
  refresh(model, state, contacts);
  return new_pairs;
}

// Removes stretches that are dry (at the start) or broken at both ends (later); vertex contacts take their place.
void MovingContacts::drop_stretches(const Model& model, ContactSet& contacts, bool dry_ones) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stretches_; ++i) {
    const auto& broken = contacts.states[i].broken;
    const bool drop = dry_ones ? is_dry(model, contacts.interfaces[i]) || contacts.interfaces[i].length == 0
                               : broken[0] && broken[1];
    if (drop) continue;
    contacts.interfaces[kept] = contacts.interfaces[i];
    contacts.elements[kept] = contacts.elements[i];
    contacts.strengths[kept] = contacts.strengths[i];
    contacts.states[kept] = contacts.states[i];
    ++kept;
  }
  const std::size_t dropped = stretches_ - kept;
  if (dropped == 0) return;
  const auto erase = [&](auto& entries) {
    const auto first = entries.begin() + static_cast<std::ptrdiff_t>(kept);
    entries.erase(first, first + static_cast<std::ptrdiff_t>(dropped));
  };
  erase(contacts.interfaces);
  erase(contacts.elements);
  erase(contacts.strengths);
  erase(contacts.states);
  stretches_ = kept;
}

void MovingContacts::refresh(const Model& model, const State& state, ContactSet& contacts) {
  std::vector<std::pair<int, int>> bonded;
  for (std::size_t i = 0; i < stretches_; ++i) {
    const Interface& interface = contacts.interfaces[i];
    bonded.emplace_back(std::min(interface.block_a, interface.block_b), std::max(interface.block_a, interface.block_b));
    set_geometry(model, current_frame(model, state, interface), contacts.elements[i]);
  }
  std::sort(bonded.begin(), bonded.end());
  const std::vector<VertexContact> found = search_.find(bonded);
  std::vector<InterfaceState> states(contacts.states.begin(),
                                     contacts.states.begin() + static_cast<std::ptrdiff_t>(stretches_));
  std::size_t old = 0;
  for (const VertexContact& contact : found) {
    while (old < known_.size() && known_[old] < contact) ++old;
    const bool is_known = old < known_.size() && !(contact < known_[old]);
    states.push_back(is_known ? contacts.states[stretches_ + old] : fresh_state());
  }
  const std::size_t total = stretches_ + found.size();
  contacts.interfaces.resize(total);
  contacts.elements.resize(total);
  contacts.strengths.resize(total);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t entry = stretches_ + i;
    const Interface interface = interface_of(model, search_.outlines(), found[i]);
    contacts.interfaces[entry] = interface;
    contacts.elements[entry] = make_element(model, interface, InterfaceLaw::classical);
    set_geometry(model, frame_of(model, state, search_.outlines(), found[i]), contacts.elements[entry]);
    contacts.strengths[entry] = {0, 0, std::tan(model.joints[at(interface.joint)].friction_angle)};
    measure(contacts.elements[entry], found[i].gap, states[entry]);
  }
  contacts.states = std::move(states);
  known_ = found;
}

}  // namespace dda
