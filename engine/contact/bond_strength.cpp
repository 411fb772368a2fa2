#include "engine/contact/bond_strength.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dda {
namespace {

// The points of the law lie at +-lever of half the length from the middle, the edges at +-1. So forces of the points
// that differ have the moment of a linear traction with 3 lever times that difference between the edges, and of two
// forces at the edges with lever times the difference.
bool tears(const InterfaceSprings& springs, const EndStrength& strength, const Vec4& force) {
  const double at_edge = (force(0) + force(2) + 3 * springs.lever * std::abs(force(2) - force(0))) / 2;
  return at_edge > strength.tension;
}

bool is_sheared_off(const InterfaceSprings& springs, const EndStrength& strength, const Vec4& force) {
  const double shear = std::max(std::abs(force(1) + force(3)), springs.lever * std::abs(force(3) - force(1)));
  return shear > 2 * strength.cohesion - strength.friction * (force(0) + force(2));
}

bool sticks(const InterfaceTrial& trial, std::size_t end) {
  return trial.capacity[end] > 0 && trial.active(static_cast<Eigen::Index>(2 * end + 1)) >= 1;
}

}  // namespace

bool break_stretch(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  const std::array<bool, 2> before = trial.broken;
  if (before[0] || before[1] || tears(springs, strength, trial.force) || is_sheared_off(springs, strength, trial.force))
    trial.broken = {true, true};
  return trial.broken != before;
}

// One that has just broken still has the forces of a bond, whose rows are those of ends that stick.
bool has_lost_its_bond(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial) {
  const bool presses = trial.force(0) + trial.force(2) < 0;
  return !presses || is_sheared_off(springs, strength, trial.force) || (!sticks(trial, 0) && !sticks(trial, 1));
}

}  // namespace dda
