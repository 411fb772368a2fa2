#include "engine/contact/row_bending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "engine/contact/block_across.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/joint_of.h"
#include "engine/model/held_flags.h"

namespace dda {
namespace {

// A block is a piece of a beam when its area is at least this part of its width times its length along the axis, which
// is taken from its centroid: twice the distance of that from the joint. Voussoirs have all of that, triangles three
// quarters.
constexpr double least_area = 0.9;

double width_along(const Model& model, int block, const Vec2& normal) {
  return width_across(model, block, normal.unitOrthogonal());
}

// A block as a piece of a beam that runs through a joint.
struct Piece {
  int block = -1;
  Vec2 axis = Vec2::Zero();      // of the beam
  double width = 0, length = 0;  // m, across and along it
  double to_joint = 0;           // m, of the centroid from the middle of the joint, along the axis

  [[nodiscard]] double area_around() const { return width * length; }
};

Piece piece_along(const Model& model, int block, const Vec2& axis) {
  return {block, axis, width_along(model, block, axis), width_across(model, block, axis)};
}

// What is nearly as small as `least`, but for round-off.
bool is_least(double area, double least) { return area * (1 - 1e-9) <= least; }

// Takes the directions near the normal of a joint that run along or across the sides of a block.
template <typename Take>
void for_each_axis(const Model& model, int block, const Vec2& normal, const Take& take) {
  const Ring& corners = block_of(model, block).shape.outer;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
    for (const Vec2& direction : {side, Vec2(side.unitOrthogonal())})
      if (std::abs(direction.dot(normal)) >= opposite_faces) take(piece_along(model, block, direction));
  }
}

// The joints of a voussoir lean against the axis of its beam, and seen along them it would look thicker than it is. So
// the axis is the direction near the joint's normal in which the block fills most of its width times length. One of the
// sides of the rectangle that is filled most lies on a side of the block. The rectangles on several sides can be filled
// alike, as they always are in a triangle: then it is the direction nearest to the normal, and the normal itself where
// that is one of them, whatever corner the outline begins with.
Piece fullest_piece(const Model& model, int block, const Vec2& normal) {
  Piece along_normal = piece_along(model, block, normal);
  if (is_least(along_normal.area_around(), block_of(model, block).moments.area)) return along_normal;
  double least = along_normal.area_around();
  for_each_axis(model, block, normal, [&](const Piece& piece) { least = std::min(least, piece.area_around()); });
  if (is_least(along_normal.area_around(), least)) return along_normal;
  Piece nearest;
  const auto nearness = [&](const Piece& piece) { return std::abs(piece.axis.dot(normal)); };
  for_each_axis(model, block, normal, [&](const Piece& piece) {
    if (is_least(piece.area_around(), least) && nearness(piece) > nearness(nearest)) nearest = piece;
  });
  return nearest;
}

Piece piece_at(const Model& model, const Interface& interface, int block) {
  Piece piece = fullest_piece(model, block, interface.normal);
  const Vec2 middle = (interface.from + interface.to) / 2;
  piece.to_joint = std::abs((block_of(model, block).moments.centroid - middle).dot(piece.axis));
  return piece;
}

bool is_piece_of_a_beam(const Model& model, const Piece& piece) {
  const double length = std::min(piece.length, 2 * piece.to_joint);
  return block_of(model, piece.block).moments.area > least_area * piece.width * length;
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

// From 0, a piece of a beam with one joint at most on each end and none beside them, seen along its axis, to 1, a part
// of a mesh: with neighbours as thick as itself on half of a side, or with an end that is halved. In between a chip or
// a thin layer at its side takes from the stiffness of a row as it grows, by less than it adds itself.
double share_of_mesh(const Model& model, const Piece& piece, const HeldSides& sides, const std::vector<bool>& held) {
  const int block = piece.block;
  const Vec2& axis = piece.axis;
  EndJoints ahead, behind;
  double left = 0, right = 0;
  for (const HeldSide& side : sides[static_cast<std::size_t>(block)]) {
    const double along = side.outward.dot(axis);
    if (std::abs(along) >= opposite_faces) {
      (along > 0 ? ahead : behind).add(side.length);
      continue;
    }
    const bool is_held = held[static_cast<std::size_t>(side.neighbour)];
    const double share =
        share_of_side(model, block, side) * (is_held ? 1 : hold_elsewhere(model, block, side.neighbour, sides));
    (side.outward.dot(axis.unitOrthogonal()) > 0 ? left : right) += share;
    if (2 * std::max(left, right) >= 1) return 1;  // nearly all blocks of a mesh, at their first neighbour
  }
  if (!is_piece_of_a_beam(model, piece)) return 1;
  return std::min(1.0, 2 * std::max({left, right, ahead.split(), behind.split()}));
}

// By how much half a block of a row turns under a moment, 1/N per m of thickness.
double flexibility_in_row(const Model& model, const Piece& piece) {
  return piece.to_joint / bending_of_section(model.material_at_start(piece.block), piece.width);
}

// By how much a block of a mesh gives way to a moment where a row grows out of it, 1/N per m of thickness. A stretch l
// of the edge of a half plane turns by 16.67/pi M/(E l^2) (O'Donnell 1960). Blocks turn against their neighbours
// besides, those as wide as the row by nearly half of that, so that 3 is left, which is half of what half a block of a
// row has; large blocks hardly turn, and all of it is left.
double flexibility_at_root(const Model& model, const Piece& piece, double length) {
  constexpr double wide = 16.67 / std::numbers::pi;
  constexpr double as_wide_as_the_row = 3;
  const double part = std::min(1.0, length / piece.width);
  const double turn = std::lerp(wide, as_wide_as_the_row, part * part);
  return turn / (side_free_modulus(model.material_at_start(piece.block)) * length * length);
}

// A block beside a joint.
struct Half {
  Piece piece;
  double row = 0;  // from 0, a part of a mesh, to 1, a piece of a row
};

// A row that grows out of a mesh or turns a corner bends at its root in the joint there alone, as between two of its
// own blocks. So the block that is most of a row decides, and the other one bends as far as it is as much of a row.
struct Bend {
  double share;  // from 0, as in a mesh, to 1
  double turn;   // of both blocks under a moment, 1/N per m of thickness
};

Bend bend_of(const Model& model, std::span<const Half> halves, double length) {
  double most = 0;
  for (const Half& half : halves) most = std::max(most, half.row);
  if (most <= 0) return {0, 0};
  double turn = 0;
  for (const Half& half : halves)
    turn += std::lerp(flexibility_at_root(model, half.piece, length), flexibility_in_row(model, half.piece),
                      half.row / most);
  return {halves.size() == 2 ? most * most : most, turn};
}

// Stiffness against half the difference of the normal gap between the ends of a joint, N/m per m of thickness.
double bending_stiffness(const Interface& interface, double turn) {
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

Bend bend_at(const Model& model, const Interface& interface, const HeldSides& sides, const std::vector<bool>& held) {
  std::array<Half, 2> halves;
  std::size_t count = 0;  // held blocks are rigid
  for (const int block : {interface.block_a, interface.block_b}) {
    if (held[static_cast<std::size_t>(block)]) continue;
    const Piece piece = piece_at(model, interface, block);
    halves[count++] = {piece, 1 - share_of_mesh(model, piece, sides, held)};
  }
  Bend bend = bend_of(model, std::span(halves).first(count), interface.length);
  if (bend.share > 0) bend.share *= 1 - tie_across(model, interface.block_a, interface.block_b, sides);
  return bend;
}

}  // namespace

double bending_of_section(const Material& material, double width) {
  return side_free_modulus(material) * width * width * width / 12;
}

void stiffen_rows(const Model& model, ContactSet& contacts) {
  const auto passes_stress = [](const InterfaceElement& element) { return element.law == InterfaceLaw::consistent; };
  if (std::ranges::none_of(contacts.elements.kinds(), passes_stress)) return;
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  const HeldSides sides = held_sides(model, contacts);
  const std::vector<bool> held = held_flags(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (!may_bend(joint_of(model, interface), elements[i])) continue;
    const Bend bend = bend_at(model, interface, sides, held);
    if (bend.share <= 0) continue;
    const double of_mesh = elements[i].stiffness(3);  // both differences have the same there
    elements[i].stiffness(2) = std::lerp(of_mesh, bending_stiffness(interface, bend.turn), bend.share);
    contacts.states[i].force(2) =
        elements[i].stiffness(2) * contacts.states[i].gap(2) + elements[i].by_loads(2) - elements[i].force_at_start(2);
  }
}

}  // namespace dda
