#include "engine/contact/moving_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/contact/acting_frame.h"
#include "engine/contact/contact_geometry.h"
#include "engine/contact/covered_corners.h"
#include "engine/contact/in_situ_force.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/make_element.h"
#include "engine/contact/projected_stretch.h"
#include "engine/contact/shared_face.h"
#include "engine/contact/succession.h"
#include "engine/contact/tied_sides.h"
#include "engine/model/rock_change.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

const JointMaterial& joint_of(const Model& model, const Interface& interface) {
  return model.joints[at(interface.joint)];
}

// The two blocks of an interface, the smaller index first.
std::pair<int, int> pair_of(const Interface& interface) { return std::minmax(interface.block_a, interface.block_b); }

class PairsOfBlocks {
 public:
  void add(const std::pair<int, int>& pair) { pairs_.push_back(pair); }
  void sort() { std::sort(pairs_.begin(), pairs_.end()); }
  // The pairs must have been sorted.
  [[nodiscard]] bool has(const std::pair<int, int>& pair) const {
    return std::binary_search(pairs_.begin(), pairs_.end(), pair);
  }

 private:
  std::vector<std::pair<int, int>> pairs_;
};

// Normal and shear force of a stretch at one end and at the other.
Vec4 ends_force(const InterfaceElement& element, const InterfaceState& state) {
  if (element.law != InterfaceLaw::projected) return state.force;
  const std::array<Vec2, 2> ends = pressing_ends(element, state);
  return {ends[0](0), ends[0](1), ends[1](0), ends[1](1)};
}

// Properties per area, for which a contact must know its share of the joint.
bool depends_on_length(const JointMaterial& joint) {
  return joint.residual_cohesion > 0 || springs_go_by_length(joint);
}

// True where both are of one corner of the vertex' block with one face of the other: under one name, or with the roles
// of two corners above each other exchanged.
bool is_same(const VertexContact& a, const VertexContact& b) {
  return (a.edge == b.edge && a.vertex == b.vertex) || a.edge_block == b.vertex_block;
}

// A contact that comes from nowhere does not press at once, and one that comes from another vertex or edge presses more
// than that one only by what it has moved (m): what it is pressed in beyond that its spring closes deeper. So a wrong
// choice of contacts brings no energy, whatever the choice.
void press_no_more(double distance, double moved, InterfaceState& state) {
  const double pressed = std::min(0.0, state.gap(0)) - moved;
  state.seat[0] = std::min(state.seat[0], distance - state.dilation[0] - pressed);
}

// A face that has grown is pressed in where it is new as it is beside, and no more: its springs begin with a share of
// the stiffness that may be small, but need not be.
void share_depth(const InterfaceState& beside, double distance, InterfaceState& state) {
  if (beside.status[0] == ContactStatus::open) return;
  const double as_pressed = distance - state.dilation[0] - std::min(0.0, beside.gap(0));
  state.seat[0] = std::max(state.seat[0], std::min(beside.seat[0], as_pressed));
}

// The springs go on with the force that the state comes with, if it presses.
void seat(const InterfaceElement& element, double distance, InterfaceState& state) {
  if (state.force(0) >= 0) return press_no_more(distance, 0, state);
  state.seat[0] = distance - state.dilation[0] - elastic_gap(state.force(0), element.stiffness(0), 0);
  state.gap(1) = elastic_gap(state.force(1), element.stiffness(1), 0);
}

// The state of a contact that was none before: broken, as it carries no tension, and failed where its joint had a bond.
InterfaceState new_state(const JointMaterial& joint) {
  const bool failed = !is_dry(joint);
  InterfaceState state;
  state.broken = {true, true};
  state.residual = {failed, failed};
  state.status = {ContactStatus::open, ContactStatus::open};
  return state;
}

// `from_stretch`: what ends of stretches leave to the contact, if any. They come with a force of their own, and with
// the depth of another contact the springs would have that one's as well. `beside`: the contact that the face is
// pressed in by already, if any.
InterfaceState first_state(const JointMaterial& joint, const InterfaceElement& element, double distance,
                           const std::optional<InterfaceState>& from_stretch, const InterfaceState* beside) {
  InterfaceState state = from_stretch.value_or(new_state(joint));
  if (from_stretch) {
    seat(element, distance, state);
    return state;
  }
  press_no_more(distance, 0, state);
  if (beside != nullptr) share_depth(*beside, distance, state);
  return state;
}

// Where corners that face each other were two contacts and one has `ended` (-1: none), the one that goes on takes the
// load of the one that presses more, which would be lost otherwise. Loads do not add up: one spring that carries both
// stores more than the two did.
std::ptrdiff_t heavier(std::ptrdiff_t earlier, std::ptrdiff_t ended, std::size_t first,
                       const std::vector<InterfaceState>& states) {
  if (ended < 0 || earlier < 0) return earlier;
  const auto pressure = [&](std::ptrdiff_t known) { return -states[first + static_cast<std::size_t>(known)].force(0); };
  return pressure(ended) > pressure(earlier) ? ended : earlier;
}

// Blocks that turn meet a little deeper, or less deep, than the first-order gaps of the step said. Deeper would be
// energy from nowhere, and a force at the start of the next step that is not what the last one found: the spring then
// closes deeper by as much.
void forgive_turn(double distance, InterfaceState& state) {
  const double deeper = std::min(0.0, state.gap(0)) - (distance - state.held_open(0));
  if (deeper > 0) state.seat[0] -= deeper;
}

// A spring that opens has lost what it was seated with, but for a depth that it has not yet come out of.
void measure(const InterfaceElement& element, double distance, InterfaceState& state) {
  const double gap = distance - state.held_open(0);
  state.gap(0) = gap;
  if (gap > 0) {
    state.status[0] = ContactStatus::open;
    state.gap(1) = 0;
    state.seat[0] = std::min(0.0, distance - state.dilation[0]);
    state.gap(0) = distance - state.held_open(0);
  } else if (state.status[0] == ContactStatus::open) {
    state.status[0] = ContactStatus::locked;
  }
  state.force(0) = gap > 0 ? 0 : element.stiffness(0) * gap;
  state.force(1) = element.stiffness(1) * state.gap(1);
}

}  // namespace

MovingContacts::MovingContacts(const Model& model, const State& state, ContactSet& contacts)
    : search_(model, state), surfaces_(model, search_.outlines()) {
  stretches_ = contacts.interfaces.size();
  end_stretches(model, state, true, contacts);
  refresh(model, state, state, contacts);
  lost_ends_.clear();
}

bool MovingContacts::follow(const Model& model, const State& state, const State& acting, double ahead,
                            ContactSet& contacts) {
  double lift = 0;
  for (const InterfaceState& each : contacts.states) lift = std::max({lift, each.held_open(0), each.held_open(1)});
  const bool new_pairs = search_.update(model, state, lift);
  search_.foresee(model, state, ahead);
  if (contacts.outline_compliance.empty()) end_stretches(model, state, false, contacts);
  refresh(model, state, acting, contacts);
  lost_ends_.clear();
  return new_pairs;
}

void MovingContacts::let_part(const Model& model, State& state, ContactSet& contacts) {
  if (contacts.outline_compliance.empty()) return;
  const std::vector<char> ends = ending_stretches(model, state, contacts, false);
  keep_ends(model, state, contacts, false, ends);
  for (std::size_t i = 0; i < stretches_; ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    if (ends[i] == 0 || element.law != InterfaceLaw::projected) continue;
    const StressLetGo stress = stress_let_go(model, state, element, contacts.states[i].force);
    state.stress[at(element.block_a)] += stress.of_a;
    state.stress[at(element.block_b)] += stress.of_b;
  }
  drop_stretches(ends, contacts);
}

bool MovingContacts::widen(const Model& model, const State& state, const Eigen::VectorXd& d) {
  constexpr double unseen = in_line / 10;  // of the smallest block: what moves by less is seen in time by later steps
  if (search_.largest_motion(d) <= unseen * search_.smallest_size()) return false;
  const bool wider = search_.widen(model, state, d);
  if (covered_.empty()) return wider;
  const auto pressed = pressed_into_each_other(search_, covered_, model, state, d);
  uncovered_.insert(uncovered_.end(), pressed.begin(), pressed.end());
  std::sort(uncovered_.begin(), uncovered_.end());
  return wider || !pressed.empty();
}

// Corners that are no longer near each other are looked at afresh when they meet again.
void MovingContacts::forget_corners_apart(const std::vector<VertexContact>& found) {
  if (uncovered_.empty()) return;
  std::vector<std::pair<int, int>> near;
  for (const VertexContact& contact : found) near.push_back(blocks_of(contact));
  std::sort(near.begin(), near.end());
  std::erase_if(uncovered_, [&](const auto& pair) { return !std::binary_search(near.begin(), near.end(), pair); });
}

void MovingContacts::leave_out(const std::vector<bool>& absent, ContactSet& contacts) {
  const auto is_absent = [&](int a, int b) { return absent[at(a)] || absent[at(b)]; };
  const auto end = contacts.interfaces.begin() + static_cast<std::ptrdiff_t>(stretches_);
  stretches_ -= static_cast<std::size_t>(std::count_if(
      contacts.interfaces.begin(), end, [&](const Interface& i) { return is_absent(i.block_a, i.block_b); }));
  std::erase_if(known_, [&](const VertexContact& c) { return is_absent(c.edge_block, c.vertex_block); });
  dda::leave_out(absent, contacts);
  search_.leave_out(absent);
}

void MovingContacts::bring_in(const Model& model, const State& state, const ComingBlocks& blocks,
                              ContactSet& contacts) {
  const auto reach = [this](int a, int b) { return ContactSearch::reach * std::min(size_of(a), size_of(b)); };
  const ContactSet joined = holding_contacts(model, state, blocks, reach);
  insert_contacts(model, joined, stretches_, contacts);
  stretches_ += joined.interfaces.size();
  search_.bring_in(blocks.absent);
  follow(model, state, blocks.acting, 0, contacts);
}

// Stretches that vertex contacts take the place of: dry ones and lone vertices at the start, later those broken at both
// ends; projected ones when they have parted. The stretches of a pair end together, since no vertex contacts are looked
// for between blocks that have one.
std::vector<char> MovingContacts::ending_stretches(const Model& model, const State& state, const ContactSet& contacts,
                                                   bool dry_ones) const {
  PairsOfBlocks firm, closed, parted;
  for (std::size_t i = 0; i < stretches_; ++i) {
    const Interface& interface = contacts.interfaces[i];
    const auto& broken = contacts.states[i].broken;
    const bool holds = dry_ones ? !is_dry(joint_of(model, interface)) : !broken[0] || !broken[1];
    if (interface.length > 0 && holds) firm.add(pair_of(interface));
    if (contacts.elements.own()[i].law != InterfaceLaw::projected) continue;
    const bool stays = touch_there_alone(model, interface) && !has_parted(model, state, interface);
    (stays ? closed : parted).add(pair_of(interface));
  }
  for (PairsOfBlocks* each : {&firm, &closed, &parted}) each->sort();
  std::vector<char> ends(stretches_);
  for (std::size_t i = 0; i < stretches_; ++i) {
    const std::pair<int, int> pair = pair_of(contacts.interfaces[i]);
    const bool stays = firm.has(pair) || (closed.has(pair) && !parted.has(pair));
    ends[i] = stays ? 0 : 1;
  }
  return ends;
}

void MovingContacts::end_stretches(const Model& model, const State& state, bool dry_ones, ContactSet& contacts) {
  const std::vector<char> ends = ending_stretches(model, state, contacts, dry_ones);
  keep_ends(model, state, contacts, dry_ones, ends);
  drop_stretches(ends, contacts);
}

// Forces, slip and dilation of stretches that end go on in the vertex contacts that take their place.
void MovingContacts::keep_ends(const Model& model, const State& state, const ContactSet& contacts, bool dry_ones,
                               const std::vector<char>& ends) {
  for (std::size_t i = 0; i < stretches_; ++i) {
    const Interface& interface = contacts.interfaces[i];
    const InterfaceState& whole = contacts.states[i];
    const bool has_failed = !is_dry(joint_of(model, interface));
    if (ends[i] == 0 || (dry_ones && has_failed)) continue;
    const Vec4 force = dry_ones ? in_situ_force(model, interface) : ends_force(contacts.elements.own()[i], whole);
    const Vec2 normal = current_frame(model, state, interface).normal;
    for (std::size_t end = 0; end < 2; ++end) {
      InterfaceState own;
      own.gap.head<2>() = whole.gap.segment<2>(static_cast<Eigen::Index>(2 * end));
      own.force.head<2>() = force.segment<2>(static_cast<Eigen::Index>(2 * end));
      own.status = {whole.status[end], ContactStatus::open};
      own.broken = {true, true};
      own.residual = {has_failed || whole.residual[end], has_failed};
      own.slip[0] = whole.slip[end];
      own.dilation[0] = whole.dilation[end];
      lost_ends_.add({interface.block_a, interface.block_b, end == 0 ? interface.from : interface.to,
                      (interface.to - interface.from).normalized(), normal, own});
    }
  }
}

Interface MovingContacts::interface_of(const Model& model, const VertexContact& contact, double share) const {
  const Outlines& outlines = search_.outlines();
  Interface interface;
  interface.block_a = contact.edge_block;
  interface.block_b = contact.vertex_block;
  interface.from = interface.to =
      model.blocks[at(contact.vertex_block)].moments.centroid + outlines.reference[at(contact.vertex)];
  interface.normal = contact.normal;
  interface.joint = surfaces_.joint_of(model, outlines, contact);
  if (depends_on_length(joint_of(model, interface))) interface.share = share;
  return interface;
}

// Returns what stretches leave to each of `found`; those that go on from `earlier` contacts get nothing. Empty where no
// stretch has ended, as in nearly all steps.
std::vector<std::optional<InterfaceState>> MovingContacts::left_by_stretches(
    const Model& model, const std::vector<VertexContact>& found, const std::vector<std::ptrdiff_t>& earlier) const {
  if (lost_ends_.empty()) return {};
  std::vector<std::size_t> places;
  std::vector<Interface> heirs;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (earlier[i] >= 0) continue;
    places.push_back(i);
    heirs.push_back(interface_of(model, found[i], 0));
  }
  const auto left = lost_ends_.shared_among(heirs, point_tolerance(model));
  std::vector<std::optional<InterfaceState>> all(found.size());
  for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = left[k];
  return all;
}

void MovingContacts::drop_stretches(const std::vector<char>& ends, ContactSet& contacts) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stretches_; ++i) {
    if (ends[i] != 0) continue;
    contacts.interfaces[kept] = contacts.interfaces[i];
    contacts.elements.edit()[kept] = contacts.elements.edit()[i];
    contacts.strengths[kept] = contacts.strengths[i];
    contacts.states[kept] = contacts.states[i];
    ++kept;
  }
  if (kept == stretches_) return;
  const auto erase = [&](auto& entries) {
    const auto place = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
    entries.erase(place(kept), place(stretches_));
  };
  erase(contacts.interfaces);
  erase(contacts.elements.edit());
  erase(contacts.strengths);
  erase(contacts.states);
  stretches_ = kept;
}

void MovingContacts::refresh(const Model& model, const State& state, const State& acting, ContactSet& contacts) {
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  std::vector<std::pair<int, int>> bonded;
  std::vector<Carrier> joints;
  for (std::size_t i = 0; i < stretches_; ++i) {
    const Interface& interface = contacts.interfaces[i];
    bonded.emplace_back(std::min(interface.block_a, interface.block_b), std::max(interface.block_a, interface.block_b));
    const InterfaceFrame frame = current_frame(model, state, interface);
    set_geometry(model, acting_frame(model, acting, interface, elements[i].law), elements[i]);
    measure_gap(model, state, interface, elements[i], contacts.states[i]);
    for (const auto& [on_a, on_b] : {std::pair{frame.from_a, frame.from_b}, {frame.to_a, frame.to_b}})
      joints.push_back({interface.block_a, interface.block_b, on_b, frame.normal, frame.normal.dot(on_b - on_a)});
  }
  std::sort(bonded.begin(), bonded.end());
  std::vector<VertexContact> found = search_.find(bonded);
  covered_ = take_out_covered(search_, joints, uncovered_, known_, found);
  forget_corners_apart(found);
  const bool by_length = std::ranges::any_of(model.joints, depends_on_length);
  const auto goes_by_length = [&](const VertexContact& contact) {
    return depends_on_length(model.joints[at(surfaces_.joint_of(model, search_.outlines(), contact))]);
  };
  if (by_length) drop_within_faces(search_.outlines(), search_.sizes(), goes_by_length, found);
  std::vector<double> shares(found.size());
  std::vector<bool> of_faces(found.size(), false);  // contacts with a share of the stiffness of a face
  if (by_length) {
    shares = shares_of_faces(search_.outlines(), search_.sizes(), found);
    std::transform(found.begin(), found.end(), of_faces.begin(), goes_by_length);
  }
  std::vector<InterfaceState> states(contacts.states.begin(),
                                     contacts.states.begin() + static_cast<std::ptrdiff_t>(stretches_));
  Succession succession(known_, found, of_faces, search_.outlines());
  const std::vector<std::optional<InterfaceState>> left = left_by_stretches(model, found, succession.earlier());
  const std::size_t total = stretches_ + found.size();
  contacts.interfaces.resize(total);
  elements.resize(total);
  contacts.strengths.resize(total);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t entry = stretches_ + i;
    const Interface interface = interface_of(model, found[i], shares[i]);
    contacts.interfaces[entry] = interface;
    elements[entry] = make_element(model, interface, InterfaceLaw::classical);
    set_geometry(model, acting_frame(model, acting, search_.outlines(), found[i]), elements[entry]);
    contacts.strengths[entry] = unbonded_strength(joint_of(model, interface), interface.share);
    const std::ptrdiff_t earlier =
        heavier(succession.earlier()[i], succession.ended_beside(found[i]), stretches_, contacts.states);
    if (earlier >= 0) {
      const VertexContact& before = known_[static_cast<std::size_t>(earlier)];
      InterfaceState& own = states.emplace_back(contacts.states[stretches_ + static_cast<std::size_t>(earlier)]);
      const double moved = std::abs(own.gap(0) + own.held_open(0) - before.gap);
      if (is_same(found[i], before)) {
        forgive_turn(found[i].gap, own);
      } else {
        press_no_more(found[i].gap, moved, own);
      }
    } else {
      const std::ptrdiff_t place = of_faces[i] ? succession.beside(found[i]) : -1;
      const InterfaceState* beside =
          place < 0 ? nullptr : &contacts.states[stretches_ + static_cast<std::size_t>(place)];
      states.push_back(first_state(joint_of(model, interface), elements[entry], found[i].gap,
                                   left.empty() ? std::nullopt : left[i], beside));
    }
    measure(elements[entry], found[i].gap, states.back());
  }
  contacts.states = std::move(states);
  known_ = found;
  if (!contacts.outline_compliance.empty()) take_off_blocks(model, contacts);
}

}  // namespace dda
