#include "engine/contact/bond_strength.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dda {
namespace {

// The points of the law lie at +-lever of half the length from the middle, the edges at +-1. So forces of the points
// that differ have the moment of a linear traction with 3 lever times that difference between the edges, and of two
// forces at the edges with lever times the difference.
bool stretch_exceeds(const InterfaceSprings& springs, const EndStrength& strength, const Vec4& force) {
  const double normal = force(0) + force(2);
  const double at_edge = (normal + 3 * springs.lever * std::abs(force(2) - force(0))) / 2;
  const double shear = std::max(std::abs(force(1) + force(3)), springs.lever * std::abs(force(3) - force(1)));
  return at_edge > strength.tension || shear > 2 * strength.cohesion - strength.friction * normal;
}

}  // namespace

bool break_stretch(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  const std::array<bool, 2> before = trial.broken;
  if (before[0] || before[1] || stretch_exceeds(springs, strength, trial.force)) trial.broken = {true, true};
  return trial.broken != before;
}

}  // namespace dda
