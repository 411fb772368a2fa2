#include "engine/contact/row_bending.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/cubic_law.h"

namespace dda {
namespace {

// Faces count as opposite within 25 degrees, as those of the voussoirs of an arch do.
constexpr double opposite_normals = -0.9;

// Of width times depth: the area of a block that is a piece of a beam. Voussoirs have more, triangles half.
constexpr double least_area = 0.9;

// The joints of one block.
struct Joints {
  int number = 0;
  Vec2 outward = Vec2::Zero();  // of the first
  bool are_opposite = true;

  void add(const Vec2& normal, double length) {
    if (number == 0) outward = normal;
    are_opposite = are_opposite && length > 0 && (number == 0 || outward.dot(normal) < opposite_normals);
    ++number;
  }
};

double width_along(const Model& model, int block, const Vec2& normal) {
  return width_across(model, block, normal.unitOrthogonal());
}

bool is_piece_of_a_beam(const Model& model, int block, const Joints& joints) {
  if (!joints.are_opposite || joints.number > 2) return false;
  const double around = width_along(model, block, joints.outward) * width_across(model, block, joints.outward);
  return block_of(model, block).moments.area > least_area * around;
}

// By how much half a block turns under a moment, 1/N per m of thickness.
double flexibility(const Model& model, const Interface& interface, int block) {
  if (model.is_held(block)) return 0;
  const Vec2 middle = (interface.from + interface.to) / 2;
  const double distance = std::abs((block_of(model, block).moments.centroid - middle).dot(interface.normal));
  const double width = width_along(model, block, interface.normal);
  return distance / (side_free_modulus(model.material_of(block)) * width * width * width / 12);
}

}  // namespace

std::vector<bool> in_rows(const Model& model, const std::vector<Interface>& interfaces) {
  const bool some_may_bend = std::ranges::any_of(model.joints, [](const JointMaterial& joint) {
    return joint.law != InterfaceLaw::classical && joint.law != InterfaceLaw::projected && !joint.stabilisation;
  });
  if (!some_may_bend) return std::vector<bool>(interfaces.size(), false);
  std::vector<Joints> joints(model.blocks.size());
  for (const Interface& interface : interfaces) {
    joints[static_cast<std::size_t>(interface.block_a)].add(interface.normal, interface.length);
    joints[static_cast<std::size_t>(interface.block_b)].add(-interface.normal, interface.length);
  }
  std::vector<bool> held(model.blocks.size(), false);
  for (const HeldBlock& each : model.held_blocks) held[static_cast<std::size_t>(each.block)] = true;
  const auto is_held = [&](int block) -> bool { return held[static_cast<std::size_t>(block)]; };
  const auto is_in_row = [&](int block) {
    return is_held(block) || is_piece_of_a_beam(model, block, joints[static_cast<std::size_t>(block)]);
  };
  std::vector<bool> found;
  for (const Interface& interface : interfaces) {
    const bool both_held = is_held(interface.block_a) && is_held(interface.block_b);
    found.push_back(interface.length > 0 && !both_held && is_in_row(interface.block_a) && is_in_row(interface.block_b));
  }
  return found;
}

double row_bending_stiffness(const Model& model, const Interface& interface) {
  const double turn =
      flexibility(model, interface, interface.block_a) + flexibility(model, interface, interface.block_b);
  return 4 / (interface.length * interface.length * turn);
}

}  // namespace dda
