#include "engine/contact/bond_strength.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

// The points of the law lie at +-lever of half the length from the middle, the edges at +-1. So forces of the points
// that differ have the moment of a linear traction with 3 lever times that difference between the edges, and of two
// forces at the edges with lever times the difference.
bool is_torn_off(const InterfaceSprings& springs, const EndStrength& strength, const Vec4& force) {
  const double at_edge = (force(0) + force(2) + 3 * springs.lever * std::abs(force(2) - force(0))) / 2;
  return at_edge > strength.tension;
}

double shear_strength(const EndStrength& strength, const Vec4& force) {
  return 2 * strength.cohesion - strength.friction * (force(0) + force(2));
}

bool is_sheared_off(const EndStrength& strength, const Vec4& force) {
  return std::abs(force(1) + force(3)) > shear_strength(strength, force);
}

// To the opposite shear of its points.
bool yields(const InterfaceSprings& springs, const EndStrength& strength, const Vec4& force) {
  return springs.lever * std::abs(force(3) - force(1)) > shear_strength(strength, force);
}

bool presses(const Vec4& force) { return force(0) + force(2) < 0; }

bool sticks(const InterfaceTrial& trial, std::size_t end) {
  return trial.capacity[end] > 0 && trial.active(static_cast<Eigen::Index>(2 * end + 1)) >= 1;
}

// Ends that slide away from or towards each other follow the strain of a block, and go nowhere.
bool slides_as_a_whole(const InterfaceTrial& trial) {
  const Vec4 shear = trial.force + trial.before;
  return !sticks(trial, 0) && !sticks(trial, 1) && shear(1) * shear(3) >= 0;
}

// Opening as a whole takes a bond, and nothing from a dry stretch.
bool leave_residual(const EndStrength& strength, InterfaceTrial& trial) {
  if (trial.residual[0] || (strength.is_dry() && strength.friction_drop == 0)) return false;
  const bool fails = presses(trial.force) ? slides_as_a_whole(trial) : !strength.is_dry();
  if (fails) trial.residual = {true, true};
  return fails;
}

Vec2 normal_forces(const Vec4& force) { return {force(0), force(2)}; }

// What has gaped at either edge by now, at this share that is closed: the edge where less of the pressure is.
std::array<double, 2> torn_so_far(double closed, const std::array<double, 2>& before, const Vec4& force) {
  std::array<double, 2> torn = before;
  double& gaping = torn[force(0) > force(2) ? 0 : 1];
  gaping = std::max(gaping, 1 - closed);
  return torn;
}

// An end that is broken, or dry, and what of the stretch has torn.
struct BrokenEnd {
  int end = 0;
  bool residual = false;
  std::array<double, 2> torn{0, 0};
};

template <typename StateOrTrial>
BrokenEnd broken_end(const StateOrTrial& interface, int end) {
  return {end, interface.residual[static_cast<std::size_t>(end)], interface.torn};
}

// The share of its cohesion that a point of the stretch has, and how it follows the gaps of both, 1/m.
double share_of_cohesion(const Vec4& force, int end) { return pressing_force(force, end) / (force(0) + force(2)); }

Vec2 share_of_cohesion_by_gaps(const Vec4& force, const Mat2& by_gaps, int end) {
  const double pressing = pressing_force(force, end), sum = force(0) + force(2);
  if (pressing == sum) return Vec2::Zero();
  const Vec2 sum_by_gaps = by_gaps.colwise().sum();
  return (pressing_slope(force, by_gaps, end) - pressing / sum * sum_by_gaps) / sum;
}

double friction_of(const EndStrength& strength, bool residual, const Vec4& force, int end) {
  return -strength.friction_now(residual) * pressing_force(force, end);
}

// Joints without cohesion, and ends that do not press, have friction alone.
bool has_cohesion(const EndStrength& strength, const BrokenEnd& broken, const Vec4& force) {
  return strength.cohesion_now(broken.residual) > 0 && pressing_force(force, broken.end) < 0;
}

// What has cohesion, of the length, and whether it follows what is closed of the stretch. The end does not matter.
struct Cohesive {
  double share = 0;
  bool follows = false;
};

Cohesive cohesive(const InterfaceSprings& springs, const BrokenEnd& broken, const Vec4& force) {
  const double closed = closed_share(springs.lever, normal_forces(force));
  if (broken.residual) return {closed, true};
  const std::array<double, 2> now = torn_so_far(closed, broken.torn, force);
  const double left = 1 - now[0] - now[1];
  return left <= 0 ? Cohesive{} : Cohesive{left, now != broken.torn};
}

double shear_capacity(const InterfaceSprings& springs, const EndStrength& strength, const BrokenEnd& broken,
                      const Vec4& force) {
  const double friction = friction_of(strength, broken.residual, force, broken.end);
  if (!has_cohesion(strength, broken, force)) return friction;
  const double whole = 2 * strength.cohesion_now(broken.residual);
  return friction + whole * cohesive(springs, broken, force).share * share_of_cohesion(force, broken.end);
}

Vec2 shear_capacity_by_gaps(const InterfaceSprings& springs, const EndStrength& strength, const BrokenEnd& broken,
                            const Vec4& force, const Mat2& by_gaps) {
  Vec2 slope = -strength.friction_now(broken.residual) * pressing_slope(force, by_gaps, broken.end);
  if (!has_cohesion(strength, broken, force)) return slope;
  const double whole = 2 * strength.cohesion_now(broken.residual);
  const Cohesive of = cohesive(springs, broken, force);
  slope += whole * of.share * share_of_cohesion_by_gaps(force, by_gaps, broken.end);
  if (!of.follows) return slope;
  return slope + whole * share_of_cohesion(force, broken.end) *
                     closed_share_by_gaps(springs.lever, normal_forces(force), by_gaps);
}

}  // namespace

bool break_stretch(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  if (trial.broken[0]) return leave_residual(strength, trial);
  const bool sheared = is_sheared_off(strength, trial.force);
  if (!sheared && !yields(springs, strength, trial.force) && !is_torn_off(springs, strength, trial.force)) return false;
  trial.broken = {true, true};
  if (sheared || !presses(trial.force)) trial.residual = {true, true};
  return true;
}

double stretch_capacity(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& state,
                        int end) {
  return shear_capacity(springs, strength, broken_end(state, end), state.force);
}

double stretch_capacity(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                        int end) {
  const bool residual = trial.residual[static_cast<std::size_t>(end)];
  const bool is_mean = trial.rule.conserves_energy;
  if (strength.cohesion_now(residual) == 0 && !is_mean)  // most joints, at no more cost than that of friction
    return friction_of(strength, residual, trial.force, end);
  const BrokenEnd broken = broken_end(trial, end);
  if (!is_mean) return shear_capacity(springs, strength, broken, trial.force);
  return 2 * shear_capacity(springs, strength, broken, (trial.force + trial.before) / 2);
}

// What the mean force is follows the gaps by half of what the force does.
Vec2 stretch_capacity_by_gaps(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                              const Mat2& by_gaps, int end) {
  const BrokenEnd broken = broken_end(trial, end);
  if (!trial.rule.conserves_energy) return shear_capacity_by_gaps(springs, strength, broken, trial.force, by_gaps);
  return 2 * shear_capacity_by_gaps(springs, strength, broken, (trial.force + trial.before) / 2, by_gaps / 2);
}

void note_torn(const InterfaceSprings& springs, InterfaceState& state) {
  if (state.residual[0] || !press_together(springs, state.broken)) return;
  state.torn = torn_so_far(closed_share(springs.lever, normal_forces(state.force)), state.torn, state.force);
}

}  // namespace dda
