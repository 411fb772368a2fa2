#include "engine/contact/sticking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"

namespace dda::sticking {
namespace {

// m, of gaps whose sign says nothing: blocks that are drawn against each other in any direction.
double round_off_of(const ContactRule& rule) { return 1e-5 * rule.touching; }

}  // namespace

bool touched(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Eigen::Index n = 2 * end;
  if (trial.start(n) <= trial.rule.touching) return true;
  if (!press_together(springs, trial.broken)) return false;
  const Vec2 forces = press_bed(bed_of(springs), {trial.start(0), trial.start(2)}).force;
  return forces(end) + std::max(0.0, forces(1 - end)) < 0;
}

void let_go_of_opening(const InterfaceSprings& springs, InterfaceTrial& trial) {
  if (presses_together(springs, trial.broken, trial.force)) return;
  for (int end = 0; end < 2; ++end)
    if (trial.start(2 * end) > 0 && trial.normal_gap(end) > 0) trial.rule.touching = -1;
}

void close_where_touching(const InterfaceSprings& springs, InterfaceTrial& trial) {
  if (press_together(springs, trial.broken)) return;
  for (int end = 0; end < ends_of(springs); ++end) {
    double& start = trial.start(2 * end);
    if (std::abs(start) <= round_off_of(trial.rule)) start = -std::numeric_limits<double>::min();
    trial.gap(2 * end) = start;
  }
}

}  // namespace dda::sticking
