#include "engine/contact/row_bending.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

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

// Where a joint holds a block.
struct HeldSide {
  Vec2 outward = Vec2::Zero();
  double length = 0;   // m, of the joint
  int neighbour = -1;  // the other block
};

using HeldSides = std::vector<std::vector<HeldSide>>;  // of every block

// From 0 to 1: how far what holds a neighbour beside `block` reaches, since what hangs at the block alone carries no
// moment past it.
double hold_elsewhere(const Model& model, int block, int neighbour, const HeldSides& sides) {
  double length = 0;
  for (const HeldSide& side : sides[static_cast<std::size_t>(neighbour)])
    if (side.neighbour != block) length += side.length;
  return std::min(1.0, 2 * length / std::sqrt(block_of(model, neighbour).moments.area));
}

// From 0 to 1: the share of a side that a joint to a neighbour takes, less where that is thinner than the block.
double share_of_side(const Model& model, int block, const HeldSide& side) {
  const double depth = width_across(model, side.neighbour, side.outward) / width_across(model, block, side.outward);
  return side.length / width_along(model, block, side.outward) * std::min(1.0, depth);
}

// Joints at one end of a piece of a beam.
struct EndJoints {
  double length = 0, longest = 0;  // m

  void add(double more) {
    length += more;
    longest = std::max(longest, more);
  }
  [[nodiscard]] double split() const { return length > 0 ? 1 - longest / length : 0; }
};

// From 0, a piece of a beam with one joint at most on each end and none beside them, seen along `normal`, to 1, a part
// of a mesh: with neighbours as thick as itself on half of a side, or with an end that is halved. In between a chip or
// a thin layer at its side takes from the stiffness of a row as it grows, by less than it adds itself.
double share_of_mesh(const Model& model, int block, const Vec2& normal, const HeldSides& sides,
                     const std::vector<bool>& held) {
  EndJoints ahead, behind;
  double left = 0, right = 0;
  for (const HeldSide& side : sides[static_cast<std::size_t>(block)]) {
    const double along = side.outward.dot(normal);
    if (std::abs(along) >= opposite) {
      (along > 0 ? ahead : behind).add(side.length);
      continue;
    }
    const bool is_held = held[static_cast<std::size_t>(side.neighbour)];
    const double share =
        share_of_side(model, block, side) * (is_held ? 1 : hold_elsewhere(model, block, side.neighbour, sides));
    (side.outward.dot(normal.unitOrthogonal()) > 0 ? left : right) += share;
    if (2 * std::max(left, right) >= 1) return 1;  // nearly all blocks of a mesh, at their first neighbour
  }
  const double around = width_along(model, block, normal) * width_across(model, block, normal);
  if (block_of(model, block).moments.area <= least_area * around) return 1;
  return std::min(1.0, 2 * std::max({left, right, ahead.split(), behind.split()}));
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

double length_to(int neighbour, const std::vector<HeldSide>& sides) {
  double length = 0;
  for (const HeldSide& side : sides)
    if (side.neighbour == neighbour) length += side.length;
  return length;
}

// From 0 to 1: how firmly one more block holds both blocks of a joint. Such a tie bears moments however small it is,
// since a row of blocks bends in its joints alone, and there by what it bends between them: a cube of c across a gap of
// u at its side bears c E u/(2 c).
double tie_across(const Model& model, int a, int b, const HeldSides& sides) {
  double most = 0;
  for (const HeldSide& side : sides[static_cast<std::size_t>(a)]) {
    const int third = side.neighbour;
    if (third == b) continue;
    const std::vector<HeldSide>& held_there = sides[static_cast<std::size_t>(third)];
    const double least = std::min(length_to(a, held_there), length_to(b, held_there));
    most = std::max(most, 2 * least / std::sqrt(block_of(model, third).moments.area));
  }
  return std::min(1.0, most);
}

HeldSides held_sides(const Model& model, const ContactSet& contacts) {
  HeldSides sides(model.blocks.size());
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!holds(joint_of(model, interface), contacts.elements.own()[i])) continue;
    const int a = interface.block_a, b = interface.block_b;
    sides[static_cast<std::size_t>(a)].push_back({interface.normal, interface.length, b});
    sides[static_cast<std::size_t>(b)].push_back({-interface.normal, interface.length, a});
  }
  return sides;
}

}  // namespace

void stiffen_rows(const Model& model, ContactSet& contacts) {
  const auto passes_stress = [](const InterfaceElement& element) { return element.law == InterfaceLaw::consistent; };
  if (std::ranges::none_of(contacts.elements.kinds(), passes_stress)) return;
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  const HeldSides sides = held_sides(model, contacts);
  const std::vector<bool> held = held_flags(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!may_bend(joint_of(model, interface), elements[i])) continue;
    const auto is_held = [&](int block) -> bool { return held[static_cast<std::size_t>(block)]; };
    if (is_held(interface.block_a) && is_held(interface.block_b)) continue;
    const auto share_of_row = [&](int block) {
      return is_held(block) ? 1 : 1 - share_of_mesh(model, block, interface.normal, sides, held);
    };
    double share = share_of_row(interface.block_a);
    if (share > 0) share *= share_of_row(interface.block_b);
    if (share > 0) share *= 1 - tie_across(model, interface.block_a, interface.block_b, sides);
    if (share <= 0) continue;
    const double of_mesh = elements[i].stiffness(3);  // both differences have the same there
    elements[i].stiffness(2) = std::lerp(of_mesh, bending_stiffness(model, interface, held), share);
    contacts.states[i].force(2) =
        elements[i].stiffness(2) * contacts.states[i].gap(2) + elements[i].by_loads(2) - elements[i].force_at_start(2);
  }
}

}  // namespace dda
