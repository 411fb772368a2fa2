// Entities of DXF as lines and points of a drawing.
#pragma once

#include <span>

#include "engine/drawing/dxf_file.h"
#include "engine/drawing/line_drawing.h"

namespace dda {

// Where a symbol is put: p -> turn p + shift, in m. What is drawn on layer 0 of a symbol is on the symbol's layer.
struct DxfPlacement {
  Mat2 turn = Mat2::Identity();
  Vec2 shift = Vec2::Zero();
  std::string layer = "0";

  [[nodiscard]] Vec2 at(const Vec2& point) const { return turn * point + shift; }
};

// The name in full where extended data has it, unless the entity was put on another layer since.
std::string layer_of(const DxfEntity& entity, const DxfPlacement& placement);

// The plane an entity is drawn in by its extrusion: seen from above, or from below, which mirrors x. InputError for any
// other, which shows an entity from the side.
Mat2 seen_from_above(const DxfEntity& entity);

// Draws the entity at the front of `entities`, which may go on over those behind it; returns how many it took, 0 for a
// kind that is no line or point.
std::size_t draw_shape(std::span<const DxfEntity> entities, const DxfPlacement& placement, Pencil& pencil);

}  // namespace dda
