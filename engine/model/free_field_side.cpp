#include "engine/model/free_field_side.h"

#include <cmath>
#include <cstddef>

#include "engine/core/error.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

const ViscousEdge& edge(const Model& model, int index) { return model.viscous_edges[static_cast<std::size_t>(index)]; }

bool is_level(const Model& model, double height, const Vec2& from, const Vec2& to) {
  const double tolerance = point_tolerance(model);
  return std::abs(from.y() - height) <= tolerance && std::abs(to.y() - height) <= tolerance;
}

}  // namespace

Segment upwards(const ViscousEdge& edge) {
  return edge.from.y() < edge.to.y() ? Segment{edge.from, edge.to} : Segment{edge.to, edge.from};
}

Vec2 foot_of(const Model& model, const FreeFieldSide& side) {
  return upwards(edge(model, side.viscous_edges.front())).start;
}

Vec2 head_of(const Model& model, const FreeFieldSide& side) {
  return upwards(edge(model, side.viscous_edges.back())).end;
}

int lowest_block(const Model& model, const FreeFieldSide& side) {
  return edge(model, side.viscous_edges.front()).block;
}

int highest_block(const Model& model, const FreeFieldSide& side) {
  return edge(model, side.viscous_edges.back()).block;
}

int held_base_of(const Model& model, const FreeFieldSide& side) {
  const Vec2 foot = foot_of(model, side);
  for (std::size_t i = 0; i < model.held_blocks.size(); ++i) {
    const Block& block = model.blocks[static_cast<std::size_t>(model.held_blocks[i].block)];
    if (locate(block.shape, foot, point_tolerance(model)) == Location::boundary) return static_cast<int>(i);
  }
  return -1;
}

bool is_at_foot(const Model& model, const FreeFieldSide& side, int block, const Vec2& from, const Vec2& to) {
  return block == lowest_block(model, side) && is_level(model, foot_of(model, side).y(), from, to);
}

bool is_at_head(const Model& model, const FreeFieldSide& side, int block, const Vec2& from, const Vec2& to) {
  return block == highest_block(model, side) && is_level(model, head_of(model, side).y(), from, to);
}

std::vector<int> supports_at_foot(const Model& model, const FreeFieldSide& side) {
  std::vector<int> found;
  const Vec2 foot = foot_of(model, side);
  for (std::size_t i = 0; i < model.supports.size(); ++i) {
    const PointSupport& support = model.supports[i];
    if (!is_at_foot(model, side, support.block, support.point, support.point)) continue;
    if ((support.point - foot).norm() > point_tolerance(model)) found.push_back(static_cast<int>(i));
  }
  return found;
}

void refuse_free_field_sides(const Model& model) {
  if (model.free_field_sides.empty()) return;
  throw InputError("", "viscous_boundaries", "with free-field sides",
                   "sides that are held: static stages find their own steps here, and columns cannot be stepped along");
}

}  // namespace dda
