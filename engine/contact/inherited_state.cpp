#include "engine/contact/inherited_state.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

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

// Where springs go by length those of another face may be many times as stiff, and would turn the depth of before into
// as many times its force. So may those of the same face when it loses another contact; when it grows as blocks slide,
// they are stiffer by little in a step. Returns the share of a depth that keeps its force.
double keep_force(const Vec2& stiffness_before, const InterfaceElement& element, bool is_other_face,
                  InterfaceState& state) {
  const double grown = is_other_face ? 1 : 2;
  if (state.gap(0) >= 0 || element.stiffness(0) <= grown * stiffness_before(0)) return 1;
  for (const Eigen::Index row : {0, 1})
    if (element.stiffness(row) > 0) state.gap(row) *= std::min(1.0, stiffness_before(row) / element.stiffness(row));
  return stiffness_before(0) / element.stiffness(0);
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

// Blocks that turn meet a little deeper, or less deep, than the first-order gaps of the step said. Deeper would be
// energy from nowhere, and a force at the start of the next step that is not what the last one found: the spring then
// closes deeper by as much.
void forgive_turn(double distance, InterfaceState& state) {
  const double deeper = std::min(0.0, state.gap(0)) - (distance - state.held_open(0));
  if (deeper > 0) state.seat[0] -= deeper;
}

}  // namespace

std::ptrdiff_t heavier(std::ptrdiff_t earlier, std::ptrdiff_t ended, std::size_t first,
                       const std::vector<InterfaceState>& states) {
  if (ended < 0 || earlier < 0) return earlier;
  const auto pressure = [&](std::ptrdiff_t known) { return -states[first + static_cast<std::size_t>(known)].force(0); };
  return pressure(ended) > pressure(earlier) ? ended : earlier;
}

InterfaceState continued_state(const InterfaceState& earlier, const VertexContact& before, const VertexContact& contact,
                               const Vec2& stiffness_before, const InterfaceElement& element) {
  InterfaceState own = earlier;
  const double moved = std::abs(own.gap(0) + own.held_open(0) - before.gap);
  const bool same = is_same(contact, before);
  const double share = keep_force(stiffness_before, element, !same, own);
  if (same) {
    forgive_turn(contact.gap, own);
  } else {
    press_no_more(contact.gap, share * moved, own);
  }
  return own;
}

InterfaceState first_state(const JointMaterial& joint, const InterfaceElement& element, double distance,
                           const InterfaceState* from_stretch, const InterfaceState* beside) {
  InterfaceState state = from_stretch == nullptr ? new_state(joint) : *from_stretch;
  if (from_stretch != nullptr) {
    seat(element, distance, state);
    return state;
  }
  press_no_more(distance, 0, state);
  if (beside != nullptr) share_depth(*beside, distance, state);
  return state;
}

EndStrength strength_of_vertex(const JointMaterial& joint, double closed, const InterfaceState& state) {
  EndStrength strength = unbonded_strength(joint, closed);
  strength.residual_cohesion *= 1 - state.torn[0];
  return strength;
}

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

}  // namespace dda
