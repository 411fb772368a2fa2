// The slope of a step's potential along a Newton step, as far as it is a straight line: without the contacts and bolts
// that can change, which add theirs point by point.
#pragma once

namespace dda {

struct LineSlope {
  double at_start = 0;
  double curvature = 0;
};

}  // namespace dda
