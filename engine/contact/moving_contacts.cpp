#include "engine/contact/moving_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "engine/contact/acting_frame.h"
#include "engine/contact/contact_geometry.h"
#include "engine/contact/contact_sharing.h"
#include "engine/contact/covered_corners.h"
#include "engine/contact/in_situ_force.h"
#include "engine/contact/inherited_state.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/joint_of.h"
#include "engine/contact/make_element.h"
#include "engine/contact/projected_stretch.h"
#include "engine/contact/shared_face.h"
#include "engine/contact/strain_jumps.h"
#include "engine/contact/succession.h"
#include "engine/contact/tied_sides.h"
#include "engine/core/parallel.h"
#include "engine/model/rock_change.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool any_ends(const std::vector<char>& ends) {
  return std::ranges::any_of(ends, [](char each) { return each != 0; });
}

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

}  // namespace

MovingContacts::MovingContacts(const Model& model, const State& state, ContactSet& contacts)
    : search_(model, state), surfaces_(model, search_.outlines()), ending_(model) {
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
  const std::vector<char> ends = ending_.find(model, state, contacts, stretches_, false);
  if (!any_ends(ends)) return;
  keep_ends(model, state, contacts, false, ends);
  // Stretches of one block that part at once let go of the stress it had with all of them, in whatever order they are.
  std::vector<std::pair<std::size_t, StressLetGo>> let_go;
  for (std::size_t i = 0; i < stretches_; ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    if (ends[i] == 0 || element.law != InterfaceLaw::projected) continue;
    let_go.emplace_back(i, stress_let_go(model, state, element, contacts.states[i].force));
  }
  for (const auto& [i, stress] : let_go) {
    const InterfaceElement& element = contacts.elements.own()[i];
    state.stress[at(element.block_a)] += stress.of_a;
    state.stress[at(element.block_b)] += stress.of_b;
  }
  drop_stretches(ends, contacts);
}

bool MovingContacts::widen(const Model& model, const State& state, const ContactSet& contacts,
                           const Eigen::VectorXd& d) {
  constexpr double unseen = in_line / 10;  // of the smallest block: what moves by less is seen in time by later steps
  if (search_.largest_motion(d) <= unseen * search_.smallest_size()) return false;
  const bool wider = search_.widen(model, state, d, {known_, of_stretches_});
  if (covered_.empty()) return wider;
  const auto jump_at = [&](int block, const Vec2& place, double near) {
    return strain_jump_at(block, place, near, model, state, contacts, d);
  };
  const auto pressed = pressed_into_each_other(search_, covered_, model, state, d, jump_at);
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
  const ContactSet joined = joined_contacts(model, state, blocks);
  const std::vector<char> ends = ending_.find(model, state, joined, joined.interfaces.size(), true);
  const ContactSet holding = holding_contacts(model, state, joined, ends, reach);
  insert_contacts(model, holding, stretches_, contacts);
  stretches_ += holding.interfaces.size();
  search_.bring_in(blocks.absent);
  follow(model, state, blocks.acting, 0, contacts);
  begin_anew(model, blocks.comes_in, contacts);
}

// Contacts of blocks that come in go on from none: a wall that is pressed beside them is not pressed by them.
void MovingContacts::begin_anew(const Model& model, const std::vector<bool>& comes_in, ContactSet& contacts) const {
  for (std::size_t k = 0; k < known_.size(); ++k) {
    const VertexContact& contact = known_[k];
    if (!comes_in[at(contact.edge_block)] && !comes_in[at(contact.vertex_block)]) continue;
    const std::size_t entry = stretches_ + k;
    const Interface& interface = contacts.interfaces[entry];
    const InterfaceElement& element = contacts.elements.own()[entry];
    InterfaceState& own = contacts.states[entry];
    own = first_state(joint_of(model, interface), element, contact.gap, nullptr, nullptr);
    measure(element, contact.gap, own);
    contacts.strengths[entry] = strength_of_vertex(joint_of(model, interface), interface.closed, own);
  }
}

void MovingContacts::end_stretches(const Model& model, const State& state, bool dry_ones, ContactSet& contacts) {
  const std::vector<char> ends = ending_.find(model, state, contacts, stretches_, dry_ones);
  if (!any_ends(ends)) return;
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
    const InterfaceElement& element = contacts.elements.own()[i];
    const Vec4 force = dry_ones ? in_situ_force(model, interface) : ends_force(element, whole);
    const Vec2 normal = current_frame(model, state, interface).normal;
    const double gaping = gaping_share(element, whole);
    for (std::size_t end = 0; end < 2; ++end) {
      InterfaceState own;
      own.gap.head<2>() = whole.gap.segment<2>(static_cast<Eigen::Index>(2 * end));
      own.force.head<2>() = force.segment<2>(static_cast<Eigen::Index>(2 * end));
      own.status = {whole.status[end], ContactStatus::open};
      own.broken = {true, true};
      own.residual = {has_failed || whole.residual[end], has_failed};
      own.slip[0] = whole.slip[end];
      own.dilation[0] = whole.dilation[end];
      own.torn[0] = gaping;
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
  if (!depends_on_length(joint_of(model, interface))) return interface;
  interface.share = share;
  interface.closed = edges_lie_on_each_other(outlines, contact) ? share : 0;
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
  const std::vector<Carrier> joints = follow_stretches(model, state, acting, contacts);
  look_beside(model, contacts);
  std::vector<VertexContact> found = search_.find(of_stretches_);
  covered_ = take_out_covered(search_, joints, uncovered_, known_, found);
  forget_corners_apart(found);
  const FoundContacts all = with_shares(model, std::move(found));
  Succession succession(known_, all.contacts, all.of_faces, search_.outlines());
  const std::vector<std::optional<InterfaceState>> left = left_by_stretches(model, all.contacts, succession.earlier());
  const std::vector<Heritage> heritage = heritage_of(all, left, contacts, succession);
  take_in(model, acting, all, heritage, contacts);
  known_ = all.contacts;
  if (!contacts.outline_compliance.empty()) take_off_blocks(model, contacts);
}

// Between the blocks of a stretch nothing else is looked for, but for those that touch elsewhere as well.
void MovingContacts::look_beside(const Model& model, const ContactSet& contacts) {
  of_stretches_.clear();
  for (std::size_t i = 0; i < stretches_; ++i) of_stretches_.push_back(blocks_of(contacts.interfaces[i]));
  std::sort(of_stretches_.begin(), of_stretches_.end());
  std::vector<HeldFace> faces = ending_.held_faces(model, contacts, stretches_);
  for (const HeldFace& face : faces) {
    const auto [first, last] = std::equal_range(of_stretches_.begin(), of_stretches_.end(), face.pair());
    of_stretches_.erase(first, last);
  }
  search_.leave_to_stretches(HeldFaces(std::move(faces)));
}

// Brings the stretches to the current geometry; returns where their ends carry blocks.
std::vector<Carrier> MovingContacts::follow_stretches(const Model& model, const State& state, const State& acting,
                                                      ContactSet& contacts) const {
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  std::vector<Carrier> ends(2 * stretches_);
  parallel_for_each(stretches_, contacts_worth_sharing, [&](std::size_t i) {
    const Interface& interface = contacts.interfaces[i];
    const InterfaceFrame frame = current_frame(model, state, interface);
    set_geometry(model, acting_frame(model, acting, interface, elements[i].law), elements[i]);
    measure_gap(model, state, interface, elements[i], contacts.states[i]);
    const double jump = strain_jump(frame, gapes(elements[i], contacts.states[i]));
    const auto end = [&](const Vec2& on_a, const Vec2& on_b) -> Carrier {
      return {interface.block_a, interface.block_b, on_b, frame.normal, frame.normal.dot(on_b - on_a), jump};
    };
    ends[2 * i] = end(frame.from_a, frame.from_b);
    ends[2 * i + 1] = end(frame.to_a, frame.to_b);
  });
  return ends;
}

// Contacts whose springs go by the length of their faces know their share of it.
MovingContacts::FoundContacts MovingContacts::with_shares(const Model& model, std::vector<VertexContact> found) const {
  FoundContacts all{std::move(found), {}, {}};
  const bool by_length = std::ranges::any_of(model.joints, depends_on_length);
  const auto goes_by_length = [&](const VertexContact& contact) {
    return depends_on_length(model.joints[at(surfaces_.joint_of(model, search_.outlines(), contact))]);
  };
  if (by_length) drop_within_faces(search_.outlines(), search_.sizes(), goes_by_length, all.contacts);
  all.shares.resize(all.contacts.size());
  all.of_faces.resize(all.contacts.size(), false);
  if (!by_length) return all;
  all.shares = shares_of_faces(search_.outlines(), search_.sizes(), all.contacts);
  std::transform(all.contacts.begin(), all.contacts.end(), all.of_faces.begin(), goes_by_length);
  return all;
}

std::vector<MovingContacts::Heritage> MovingContacts::heritage_of(
    const FoundContacts& all, const std::vector<std::optional<InterfaceState>>& left, const ContactSet& contacts,
    Succession& succession) const {
  std::vector<Heritage> heritage(all.contacts.size());
  const std::span<const InterfaceState> known = std::span(contacts.states).subspan(stretches_);
  for (std::size_t i = 0; i < heritage.size(); ++i) {
    const VertexContact& contact = all.contacts[i];
    Heritage& own = heritage[i];
    own.earlier = heavier(succession.earlier()[i], succession.ended_beside(contact), stretches_, contacts.states);
    if (own.earlier >= 0) continue;
    own.beside = all.of_faces[i] ? succession.beside(contact, known) : -1;
    if (!left.empty() && left[i]) own.from_stretch = &*left[i];
  }
  return heritage;
}

// Puts what was found in the place of the vertex contacts of before.
void MovingContacts::take_in(const Model& model, const State& acting, const FoundContacts& all,
                             const std::vector<Heritage>& heritage, ContactSet& contacts) {
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  stiffness_before_.clear();
  for (std::size_t i = stretches_; i < elements.size(); ++i)
    stiffness_before_.emplace_back(elements[i].stiffness.head<2>());
  states_before_.assign(contacts.states.begin() + static_cast<std::ptrdiff_t>(stretches_), contacts.states.end());
  const std::size_t total = stretches_ + all.contacts.size();
  contacts.interfaces.resize(total);
  elements.resize(total);
  contacts.strengths.resize(total);
  contacts.states.resize(total);
  parallel_for_each(all.contacts.size(), contacts_worth_sharing, [&](std::size_t i) {
    const VertexContact& contact = all.contacts[i];
    const std::size_t entry = stretches_ + i;
    const Interface interface = interface_of(model, contact, all.shares[i]);
    contacts.interfaces[entry] = interface;
    elements[entry] = make_element(model, interface, InterfaceLaw::classical);
    set_geometry(model, acting_frame(model, acting, search_.outlines(), contact), elements[entry]);
    contacts.states[entry] = state_of(joint_of(model, interface), elements[entry], contact, heritage[i]);
    contacts.strengths[entry] =
        strength_of_vertex(joint_of(model, interface), interface.closed, contacts.states[entry]);
  });
}

InterfaceState MovingContacts::state_of(const JointMaterial& joint, const InterfaceElement& element,
                                        const VertexContact& contact, const Heritage& heritage) const {
  InterfaceState own;
  if (heritage.earlier >= 0) {
    const auto earlier = static_cast<std::size_t>(heritage.earlier);
    own = continued_state(states_before_[earlier], known_[earlier], contact, stiffness_before_[earlier], element);
  } else {
    const InterfaceState* beside =
        heritage.beside < 0 ? nullptr : &states_before_[static_cast<std::size_t>(heritage.beside)];
    own = first_state(joint, element, contact.gap, heritage.from_stretch, beside);
  }
  measure(element, contact.gap, own);
  return own;
}

}  // namespace dda
