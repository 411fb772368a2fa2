#include "engine/contact/row_bending.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/cubic_law.h"
#include "engine/model/held_flags.h"

namespace dda {
namespace {

// Faces count as opposite within 25 degrees, as those of the voussoirs of an arch do.
constexpr double opposite = 0.9;

// A block is a piece of a beam when its area is at least this part of width times depth. Voussoirs have more, triangles
// half.
constexpr double least_area = 0.9;

double width_along(const Model& model, int block, const Vec2& normal) {
  return width_across(model, block, normal.unitOrthogonal());
}

// Seen along `normal`: one of the joints on these sides at most on each end, and none beside them.
bool is_piece_of_a_beam(const Model& model, int block, const Vec2& normal, const std::vector<Vec2>& sides) {
  int ahead = 0;
  int behind = 0;
  for (const Vec2& outward : sides) {
    const double along = outward.dot(normal);
    if (std::abs(along) < opposite) return false;
    ++(along > 0 ? ahead : behind);
  }
  if (ahead > 1 || behind > 1) return false;
  const double around = width_along(model, block, normal) * width_across(model, block, normal);
  return block_of(model, block).moments.area > least_area * around;
}

// By how much half a block turns under a moment, 1/N per m of thickness.
double flexibility(const Model& model, const Interface& interface, int block) {
  const Vec2 middle = (interface.from + interface.to) / 2;
  const double distance = std::abs((block_of(model, block).moments.centroid - middle).dot(interface.normal));
  const double width = width_along(model, block, interface.normal);
  return distance / (side_free_modulus(model.material_at_start(block)) * width * width * width / 12);
}

// Stiffness against half the difference of the normal gap between the ends of a joint, N/m per m of thickness.
double bending_stiffness(const Model& model, const Interface& interface, const std::vector<bool>& held) {
  double turn = 0;
  for (const int block : {interface.block_a, interface.block_b})
    if (!held[static_cast<std::size_t>(block)]) turn += flexibility(model, interface, block);
  return 4 / (interface.length * interface.length * turn);
}

// Holds both blocks together. What was broken has the classical law; a corner, and what only presses and rubs, holds
// nothing.
bool holds(const JointMaterial& joint, const InterfaceElement& element) {
  if (element.length == 0 || is_dry(joint)) return false;
  return joint.bonded || element.law != InterfaceLaw::classical;
}

bool may_bend(const JointMaterial& joint, const InterfaceElement& element) {
  return element.law == InterfaceLaw::consistent && !joint.stabilisation;
}

const JointMaterial& joint_of(const Model& model, const Interface& interface) {
  return model.joints[static_cast<std::size_t>(interface.joint)];
}

// Outward, of every block, where joints hold it.
std::vector<std::vector<Vec2>> held_sides(const Model& model, const ContactSet& contacts) {
  std::vector<std::vector<Vec2>> sides(model.blocks.size());
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!holds(joint_of(model, interface), contacts.elements.own()[i])) continue;
    sides[static_cast<std::size_t>(interface.block_a)].push_back(interface.normal);
    sides[static_cast<std::size_t>(interface.block_b)].emplace_back(-interface.normal);
  }
  return sides;
}

}  // namespace

void stiffen_rows(const Model& model, ContactSet& contacts) {
  const auto passes_stress = [](const InterfaceElement& element) { return element.law == InterfaceLaw::consistent; };
  if (std::ranges::none_of(contacts.elements.kinds(), passes_stress)) return;
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  const std::vector<std::vector<Vec2>> sides = held_sides(model, contacts);
  const std::vector<bool> held = held_flags(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!may_bend(joint_of(model, interface), elements[i])) continue;
    const auto is_held = [&](int block) -> bool { return held[static_cast<std::size_t>(block)]; };
    const auto is_in_row = [&](int block) {
      return is_held(block) ||
             is_piece_of_a_beam(model, block, interface.normal, sides[static_cast<std::size_t>(block)]);
    };
    const bool both_held = is_held(interface.block_a) && is_held(interface.block_b);
    if (both_held || !is_in_row(interface.block_a) || !is_in_row(interface.block_b)) continue;
    elements[i].stiffness(2) = bending_stiffness(model, interface, held);
    contacts.states[i].force(2) =
        elements[i].stiffness(2) * contacts.states[i].gap(2) + elements[i].by_loads(2) - elements[i].force_at_start(2);
  }
}

}  // namespace dda
