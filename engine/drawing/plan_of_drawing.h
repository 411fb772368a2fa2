// From a drawing to a plan of rock.
#pragma once

#include "engine/cutting/rock_plan.h"
#include "engine/drawing/layers.h"
#include "engine/drawing/line_drawing.h"

namespace dda {

struct DrawingOptions {
  std::map<std::string, LayerUse> layers;
  ChordTolerance chords;
  double reach = 0;  // m, within which ends of lines belong together; 0: 1e-6 of the diameter of all that is drawn
};

// Boundary, holes, lines, openings, points and marks by the layers of the drawing; layers of points and marks go by the
// words of role_names(). The boundary stays empty where no layer has one. A drawing of blocks gives these, and the
// joints along them. Throws InputError, whose field says where in the drawing.
RockPlan plan_of(const LineDrawing& drawing, const DrawingOptions& options);

}  // namespace dda
