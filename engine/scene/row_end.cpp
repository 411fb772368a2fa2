#include "engine/scene/row_end.h"

#include <cstddef>
#include <set>

#include "engine/contact/block_across.h"
#include "engine/contact/row_bending.h"

namespace dda {
namespace {

// What takes this part of a width counts as all of it.
constexpr double all_across = 0.9;

// What lies beyond the side opposite to a held one: where the row goes on.
struct Beyond {
  std::set<int> blocks;
  double length = 0;  // m, along which they touch

  void add(const Stretch& stretch) {
    blocks.insert(stretch.block);
    length += (stretch.to - stretch.from).norm();
  }
};

// Nothing where another block lies on any other side.
std::optional<Beyond> beyond(const Stretch& held, const GroundPlan& plan, const Model& model) {
  const Ring& corners = block_of(model, held.block).shape.outer;
  Beyond result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment side{corners[i], corners[(i + 1) % corners.size()]};
    const Vec2 outward = -(side.end - side.start).normalized().unitOrthogonal();  // outlines run counter-clockwise
    for (const Stretch& stretch : plan.stretches_along(side)) {
      if (stretch.block == held.block || stretch.inward.dot(outward) < 0) continue;
      if (outward.dot(held.inward) < opposite_faces) return std::nullopt;
      result.add(stretch);
    }
  }
  return result;
}

}  // namespace

std::optional<double> bending_of_row_end(const Stretch& held, const GroundPlan& plan, const Model& model) {
  const Vec2 along = held.to - held.from;
  const double width = width_across(model, held.block, along.normalized());
  if (along.norm() < all_across * width) return std::nullopt;
  const std::optional<Beyond> rest = beyond(held, plan, model);
  if (!rest || rest->blocks.size() != 1 || rest->length < all_across * width) return std::nullopt;
  const Vec2 middle = (held.from + held.to) / 2;
  const double distance = (block_of(model, held.block).moments.centroid - middle).dot(held.inward);
  return bending_of_section(model.material_of(held.block), width) / distance;
}

}  // namespace dda
