// What the bed of a broken projected stretch (no_tension_bed.h) answers in the course of a step.
//
// With b(g) the forces of the bed at the gaps of both points, g0 those of the start of the step and g1 those reached:
//   bed alone           b(g1)
//   conserving energy   2 m - b(g0), m the mean of b on the straight way from g0 to g1, whose work is what the bed
//                       stores; a balance of means turns that into m
//   beside dashpots     b(g1 + h (g1 - g0)), h = dashpot * dashpot_rate / stiffness; g0 = 0 of a bed that was open
// Where the bed stays closed the last is k g1 + C (g1 - g0), as of one end. It never pulls, and takes energy whatever
// it does: b grows with the gaps, so (b(g1 + h (g1 - g0)) - b(g1)) . (g1 - g0) >= 0, and b(g1) . g0 <= 0 where g0 is
// open. Each has a convex potential in g1. The last two together have none that never pulls, and are refused.
#pragma once

#include "engine/contact/interface_trial.h"
#include "engine/contact/no_tension_bed.h"

namespace dda {

inline bool has_dashpots(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  return trial.rule.dashpot_rate != 0 && !springs.dashpot.isZero(0);
}

// At these gaps of both points.
BedAnswer answer_of_bed(const InterfaceSprings& springs, const InterfaceTrial& trial, const Vec2& gaps);

}  // namespace dda
