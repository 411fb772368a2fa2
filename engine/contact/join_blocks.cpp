#include "engine/contact/join_blocks.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "engine/contact/block_across.h"
#include "engine/contact/contact_geometry.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/joint_of.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/make_element.h"
#include "engine/contact/projected_stretch.h"

namespace dda {
namespace {

std::size_t at(int block) { return static_cast<std::size_t>(block); }

constexpr std::array<Eigen::Index, 2> normal_rows = {0, 2};

// Joins two blocks by a consistent or cubic joint without force: its gap and the stress it passes count from now on.
void join_passing_stress(const Model& model, const State& state, const Interface& interface, InterfaceElement& element,
                         InterfaceState& own) {
  const Vec3 &stress_a = state.stress[at(interface.block_a)], &stress_b = state.stress[at(interface.block_b)];
  element.gap_at_start.setZero();
  element.force_at_start.setZero();
  measure_gap(model, state, interface, element, own);
  element.gap_at_start = own.gap;
  own.gap.setZero();
  element.force_at_start = elastic_force(element, own.gap, stress_a, stress_b);
}

// Starts what can close and open: gaps are as wide as blocks are apart, and closed springs are free of force. An end
// that is open is broken, as a whole one is a spring that pulls across its gap: the balance of the first step would
// have that force grow from nothing, and what the end keeps of it would be another.
void leave_open(const std::array<double, 2>& apart, InterfaceState& own) {
  for (const std::size_t end : {0U, 1U}) {
    own.gap(normal_rows[end]) = std::max(apart[end], 0.0);
    own.broken[end] = apart[end] > 0;
    own.status[end] = own.broken[end] ? ContactStatus::open : ContactStatus::locked;
  }
}

// The gaps of a dry stretch at its two points, where its ends are as wide as the blocks are apart, or seated.
Vec4 gaps_between(const EndsApart& ends, double lever) {
  const double from = std::max(ends.from.x(), 0.0), to = std::max(ends.to.x(), 0.0);
  const double middle = (from + to) / 2, turn = lever * (to - from) / 2;
  return {middle - turn, 0, middle + turn, 0};
}

// The own traction of a block at a stretch, Pa, normal and shear. A block that comes in has none: it is free of stress,
// and has its weight from then on.
Vec2 own_traction(const State& state, const ComingBlocks& blocks, int block, const InterfaceElement& element,
                  const Vec2& beside_stress) {
  if (blocks.comes_in[at(block)]) return Vec2::Zero();
  const Vec2 normal = normal_of(element);
  return local_axes(normal) * (traction_rows(normal) * state.stress[at(block)]) + beside_stress;
}

// Joins two blocks by a stretch of the projected law without force: their own tractions and gaps count from now on.
void join_projected(const Model& model, const State& state, const ComingBlocks& blocks, const Interface& interface,
                    InterfaceElement& element, InterfaceState& own) {
  element.gap_at_start.setZero();
  element.force_at_start << own_traction(state, blocks, element.block_a, element, element.beside_stress_a),
      own_traction(state, blocks, element.block_b, element, element.beside_stress_b);
  element.force_at_start *= element.length;
  element.beside_stress_a -= traction_when_joined(element, false);
  element.beside_stress_b -= traction_when_joined(element, true);
  const bool dry = is_dry(joint_of(model, interface));
  const EndsApart ends = ends_apart(model, state, interface);
  const Vec4 gap = dry ? gaps_between(ends, element.lever) : Vec4::Zero();
  element.gap_at_start = gap_as_it_lies(model, state, interface, element, own) - gap;
  own.gap = gap;
  own.broken = {dry, dry};
  answer_gaps(element, own);
  if (ends.from.x() <= 0 && ends.to.x() <= 0) own.status = {ContactStatus::locked, ContactStatus::locked};
}

void join(const Model& model, const State& state, const ComingBlocks& blocks, const Interface& interface,
          InterfaceElement& element, InterfaceState& own) {
  const bool dry = is_dry(joint_of(model, interface));
  if (dry && element.law != InterfaceLaw::projected) element = make_element(model, interface, InterfaceLaw::classical);
  set_geometry(model, acting_frame(model, blocks.acting, interface, element.law), element);
  own = {};
  if (has_stress_rows(element)) return join_passing_stress(model, state, interface, element, own);
  if (element.law == InterfaceLaw::projected) return join_projected(model, state, blocks, interface, element, own);
  if (!dry) return;
  const EndsApart ends = ends_apart(model, state, interface);
  leave_open({ends.from.x(), ends.to.x()}, own);
}

void append(const ContactSet& from, std::size_t i, ContactSet& to) {
  to.interfaces.push_back(from.interfaces[i]);
  to.elements.edit().push_back(from.elements[i]);
  to.strengths.push_back(from.strengths[i]);
  to.states.push_back(from.states[i]);
}

void rest(const State& state, const InterfaceElement& element, InterfaceState& own) {
  own.gap -= element.rows_a * state.displacement[at(element.block_a)] +
             element.rows_b * state.displacement[at(element.block_b)];
}

// Rows that have become longer bend as before where they were one.
void fit_new(const Model& model, const std::vector<bool>& is_new, ContactSet& contacts) {
  const ContactSet before = contacts;
  fit_to_neighbours(model, contacts);
  for (std::size_t i = 0; i < is_new.size(); ++i) {
    if (is_new[i]) continue;
    contacts.elements.edit()[i].stiffness = before.elements.own()[i].stiffness;
    contacts.states[i].force = before.states[i].force;
  }
}

}  // namespace

ContactSet joined_contacts(const Model& model, const State& state, const ComingBlocks& blocks) {
  ContactSet drawn = make_contacts(model);
  leave_out(blocks.absent, drawn);
  ContactSet joined;
  for (std::size_t i = 0; i < drawn.interfaces.size(); ++i) {
    const Interface& interface = drawn.interfaces[i];
    if (!blocks.comes_in[at(interface.block_a)] && !blocks.comes_in[at(interface.block_b)]) continue;
    append(drawn, i, joined);
    join(model, state, blocks, interface, joined.elements.edit().back(), joined.states.back());
  }
  return joined;
}

ContactSet holding_contacts(const Model& model, const State& state, const ContactSet& joined,
                            const std::vector<char>& ends, const std::function<double(int, int)>& reach) {
  std::set<std::pair<int, int>> apart;
  for (const Interface& each : joined.interfaces) {
    const EndsApart by = ends_apart(model, state, each);
    if (std::max(by.from.norm(), by.to.norm()) > reach(each.block_a, each.block_b)) apart.insert(blocks_of(each));
  }
  ContactSet kept;
  for (std::size_t i = 0; i < joined.interfaces.size(); ++i)
    if (ends[i] == 0 && !apart.contains(blocks_of(joined.interfaces[i]))) append(joined, i, kept);
  return kept;
}

Vec2 traction_when_joined(const InterfaceElement& element, bool of_b) {
  return element.force_at_start.segment<2>(of_b ? 2 : 0) / element.length;
}

void bring_in(const Model& model, const State& state, const ComingBlocks& blocks, bool at_rest, ContactSet& contacts) {
  ContactSet joined = joined_contacts(model, state, blocks);
  if (at_rest)
    for (std::size_t i = 0; i < joined.states.size(); ++i) rest(state, joined.elements.own()[i], joined.states[i]);
  std::vector<Interface> drawn = find_interfaces(model);
  ContactSet all;
  all.can_change = contacts.can_change;
  std::vector<bool> is_new;
  std::size_t old_ones = 0, new_ones = 0;
  for (const Interface& interface : drawn) {
    const int a = interface.block_a, b = interface.block_b;
    if (blocks.absent[at(a)] || blocks.absent[at(b)]) continue;
    is_new.push_back(blocks.comes_in[at(a)] || blocks.comes_in[at(b)]);
    append(is_new.back() ? joined : contacts, is_new.back() ? new_ones++ : old_ones++, all);
  }
  contacts = std::move(all);
  fit_new(model, is_new, contacts);
}

void insert_contacts(const Model& model, const ContactSet& more, std::size_t place, ContactSet& contacts) {
  const auto insert = [place](const auto& from, auto& to) {
    to.insert(to.begin() + static_cast<std::ptrdiff_t>(place), from.begin(), from.end());
  };
  insert(more.interfaces, contacts.interfaces);
  insert(more.elements.own(), contacts.elements.edit());
  insert(more.strengths, contacts.strengths);
  insert(more.states, contacts.states);
  std::vector<bool> is_new(contacts.interfaces.size(), false);
  std::fill_n(is_new.begin() + static_cast<std::ptrdiff_t>(place), more.interfaces.size(), true);
  fit_new(model, is_new, contacts);
}

}  // namespace dda
