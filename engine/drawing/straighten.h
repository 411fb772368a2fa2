// From curves to chords.
#pragma once

#include <vector>

#include "engine/drawing/line_drawing.h"

namespace dda {

// The points of every line of the drawing, in order. Chords of curves have a corner wherever a line of the drawing
// starts, ends or turns on the curve, or a point lies on it, within `reach` (m): a joint drawn up to an arc would
// otherwise end short of its chord, inside a block, and a point on the arc lie outside of all blocks. So they have
// where a line crosses the curve and ends before it meets the chord. Throws InputError for tolerances that ask for too
// many chords.
std::vector<std::vector<Vec2>> straightened(const LineDrawing& drawing, const ChordTolerance& tolerance, double reach);

// m, the largest distance of two points that are drawn.
double diameter_of(const LineDrawing& drawing);

}  // namespace dda
