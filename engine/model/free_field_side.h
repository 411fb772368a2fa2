// What stands along a free-field side, by where it lies in the drawing.
#pragma once

#include <vector>

#include "engine/core/types.h"
#include "engine/geometry/segment.h"
#include "engine/model/model.h"

namespace dda {

// A viscous edge from its lower to its upper end.
Segment upwards(const ViscousEdge& edge);

// The lowest and the highest point of a side.
Vec2 foot_of(const Model& model, const FreeFieldSide& side);
Vec2 head_of(const Model& model, const FreeFieldSide& side);

// The block whose edge the side's lowest, or highest, viscous edge is.
int lowest_block(const Model& model, const FreeFieldSide& side);
int highest_block(const Model& model, const FreeFieldSide& side);

// Index into Model::held_blocks of what the side stands on, held and with the foot on its outline (the first entry of
// that block); -1 where none is.
int held_base_of(const Model& model, const FreeFieldSide& side);

// Stretches of the underside and of the top of a side: of its lowest (highest) block, level with its foot (head).
bool is_at_foot(const Model& model, const FreeFieldSide& side, int block, const Vec2& from, const Vec2& to);
bool is_at_head(const Model& model, const FreeFieldSide& side, int block, const Vec2& from, const Vec2& to);

// Indices into Model::supports of the points that hold the lowest block from below, without that at the foot, which can
// belong to the side.
std::vector<int> supports_at_foot(const Model& model, const FreeFieldSide& side);

// For searches whose static stages find their own steps, with which columns cannot be stepped along.
void refuse_free_field_sides(const Model& model);

}  // namespace dda
