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
  interface.joint = model.joint_index(contact.edge_block, contact.vertex_block);
  return interface;
}

// Both blocks feel the contact at the vertex, so its forces have no moment between them.
InterfaceFrame frame_of(const Model& model, const State& state, const Outlines& outlines,
                        const VertexContact& contact) {
  const Vec2& point = outlines.current[at(contact.vertex)];
  return {point,
          point,
          point,
          point,
          contact.normal,
          current_centroid(model, state, contact.edge_block),
          current_centroid(model, state, contact.vertex_block)};
}

// A dry contact is broken from the start: friction is all that it has.
InterfaceState fresh_state() {
  InterfaceState state;
  state.broken = {true, true};
  state.status = {ContactStatus::open, ContactStatus::open};
  return state;
}

// Says for every contact found which known one it continues, if any; each is continued once. A contact that is not
// known by its name may be so under another: a vertex went over to the next edge in line, or of two corners above each
// other the other one now is the vertex. (Exchanging the blocks turns normal and gap both, so the state stays as it
// is.)
class Succession {
 public:
  Succession(const std::vector<VertexContact>& known, const std::vector<VertexContact>& found, const Outlines& outlines)
      : known_(known), outlines_(outlines), taken_(known.size(), false), earlier_(found.size(), -1) {
    for (const auto& rule : {&Succession::same, &Succession::next_edge, &Succession::exchanged})
      for (std::size_t i = 0; i < found.size(); ++i)
        if (earlier_[i] < 0) earlier_[i] = (this->*rule)(found[i]);
  }

  // Index of the known contact, or -1.
  [[nodiscard]] const std::vector<std::ptrdiff_t>& earlier() const { return earlier_; }

 private:
  std::ptrdiff_t same(const VertexContact& contact) { return take(contact.edge, contact.vertex, contact.normal); }

  std::ptrdiff_t next_edge(const VertexContact& contact) {
    const auto before = take(outlines_.previous[at(contact.edge)], contact.vertex, contact.normal);
    return before >= 0 ? before : take(outlines_.next[at(contact.edge)], contact.vertex, contact.normal);
  }

  std::ptrdiff_t exchanged(const VertexContact& contact) {
    for (const int corner : {contact.edge, outlines_.next[at(contact.edge)]}) {
      for (const int edge : {contact.vertex, outlines_.previous[at(contact.vertex)]})
        if (const auto known = take(edge, corner, -contact.normal); known >= 0) return known;
    }
    return -1;
  }

  std::ptrdiff_t take(int edge, int vertex, const Vec2& normal) {
    constexpr double same_direction = 0.99;  // cosine; far more than a step turns a block
    VertexContact wanted;
    wanted.edge = edge;
    wanted.vertex = vertex;
    const auto place = std::lower_bound(known_.begin(), known_.end(), wanted);
    if (place == known_.end() || wanted < *place || place->normal.dot(normal) < same_direction) return -1;
    const std::ptrdiff_t index = place - known_.begin();
    if (taken_[static_cast<std::size_t>(index)]) return -1;
    taken_[static_cast<std::size_t>(index)] = true;
    return index;
  }

  const std::vector<VertexContact>& known_;
  const Outlines& outlines_;
  std::vector<bool> taken_;
  std::vector<std::ptrdiff_t> earlier_;
};

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
    const bool drop =
        dry_ones ? is_dry(model, contacts.interfaces[i]) || contacts.interfaces[i].length == 0 : broken[0] && broken[1];
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
  const Succession succession(known_, found, search_.outlines());
  for (const std::ptrdiff_t earlier : succession.earlier())
    states.push_back(earlier >= 0 ? contacts.states[stretches_ + static_cast<std::size_t>(earlier)] : fresh_state());
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
