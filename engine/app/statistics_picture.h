// The figures by which jointed rock is described, as curves and a rose (SVG).
#pragma once

#include <string>

#include "engine/app/cut_report.h"
#include "engine/scene/cut_scene.h"

namespace dda {

// Which share of the blocks is smaller than an area (m2), and which share of all area they make up; the same of the
// aspect of blocks, and of the lengths (m) of straight runs of joints; and a rose of these runs, whose wedges of ten
// degrees have areas that go with the length of the runs in them. All rock of the scene together, with the numbers of
// cut.json's "statistics" of each above.
std::string statistics_picture(const CutScene& scene, const CutFigures& figures);

}  // namespace dda
