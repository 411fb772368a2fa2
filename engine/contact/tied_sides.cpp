#include "engine/contact/tied_sides.h"

#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/interface.h"

namespace dda {
namespace {

// From the partner to the point.
Vec2 way_of(const PointSupport& tie) { return tie.point - *tie.partner; }

}  // namespace

std::optional<TiedSides> tied_sides(const Model& model, int block, const Vec2& normal) {
  const auto found = model.joint_of_block_pair.find({block, block});
  if (found == model.joint_of_block_pair.end()) return std::nullopt;
  if (model.joints[static_cast<std::size_t>(found->second)].law != InterfaceLaw::projected) return std::nullopt;
  Interface interface;
  interface.block_a = interface.block_b = block;
  interface.joint = found->second;
  interface.normal = normal;
  interface.length = block_of(model, block).moments.area / width_across(model, block, normal);
  const Vec2 softness = projected_softness(model, interface);
  const Vec4 stiffness = projected_stiffness(model, interface, softness);
  return TiedSides{interface.length, softness.sum(), stiffness.head<2>() + stiffness.tail<2>()};
}

std::optional<TiedSides> tied_sides(const Model& model, const PointSupport& tie) {
  if (!tie.partner) return std::nullopt;
  return tied_sides(model, tie.block, way_of(tie).normalized());
}

Mat23 gap_by_stress(const TiedSides& sides, const PointSupport& tie) {
  return -sides.softness * tie.direction * tie.direction.transpose() * traction_rows(way_of(tie).normalized());
}

void take_off_blocks(const Model& model, ContactSet& contacts) {
  take_off_blocks(model.blocks.size(), contacts);
  for (const PointSupport& tie : model.supports) {
    const auto sides = tied_sides(model, tie);
    if (!sides) continue;
    if (contacts.outline_compliance.empty()) take_off_nothing(model.blocks.size(), contacts);
    const Mat23 rows = gap_by_stress(*sides, tie);
    contacts.outline_compliance[static_cast<std::size_t>(tie.block)] +=
        sides->length / sides->softness * rows.transpose() * rows;
  }
}

}  // namespace dda
