#include "engine/contact/rising_end.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/end_answer.h"

namespace dda {
namespace {

// The share of the shear spring that is left at least of its stiffness and of what pressure gains by slip together.
constexpr double least_share = 0.25;

// What an end is and where it is. Slips count towards the side that the tangential gap is on.
struct RisingEnd {
  double normal_stiffness, shear_stiffness;  // N/m per m of thickness, of spring and dashpot together
  double normal_gap, way;                    // m, without what it rides up in the step; and the size of the tangential
  double friction, cohesion;
  double tangent, reach;  // of the dilation angle; m, slip beyond which it rises no further
  double before;          // m, slip before the step: negative on the way back

  [[nodiscard]] double rise(double slip) const {
    return tangent * (std::min(std::abs(before + slip), reach) - std::min(std::abs(before), reach));
  }
  [[nodiscard]] double pressure(double slip) const { return normal_stiffness * std::max(0.0, rise(slip) - normal_gap); }
  [[nodiscard]] double capacity(double pressure) const { return pressure > 0 ? cohesion + friction * pressure : 0; }
  // Shear of the spring beyond what the end carries: 0 at the slip sought.
  [[nodiscard]] double beyond(double slip) const { return shear_stiffness * (way - slip) - capacity(pressure(slip)); }
  // Rise by slip from there on.
  [[nodiscard]] double slope_after(double slip) const {
    const double total = before + slip;
    if (total >= 0) return total < reach ? tangent : 0;
    return total >= -reach ? -tangent : 0;
  }
  // Slope of the shear force over the slip with its sign turned: above 0 where more slip is resisted.
  [[nodiscard]] double resistance(double slope) const {
    return std::max(shear_stiffness + friction * normal_stiffness * slope, least_share * shear_stiffness);
  }
};

// A spring and a dashpot side by side are one spring, whose gap counts from nearer to where the step began.
struct SpringWithDashpot {
  double stiffness;  // N/m per m of thickness
  double gap;        // m
};

SpringWithDashpot together(const InterfaceSprings& springs, const InterfaceTrial& trial, Eigen::Index row,
                           double start) {
  const double dashpot = springs.dashpot(row) * trial.rule.dashpot_rate;
  const double stiffness = springs.stiffness(row) + dashpot;
  return {stiffness, dashpot == 0 ? trial.gap(row) : trial.gap(row) - dashpot * start / stiffness};
}

// Which way the end is sheared: 1 or -1.
double side_of(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Eigen::Index row = 2 * end + 1;
  return std::copysign(1, together(springs, trial, row, trial.start(row)).gap);
}

RisingEnd end_of(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end,
                 double side) {
  const auto e = static_cast<std::size_t>(end);
  const bool residual = trial.residual[e];
  const Eigen::Index n = 2 * end;
  const SpringWithDashpot normal = together(springs, trial, n, end_answer::pressed(trial.start(n)));
  const SpringWithDashpot shear = together(springs, trial, n + 1, trial.start(n + 1));
  return {normal.stiffness,
          shear.stiffness,
          normal.gap,
          side * shear.gap,
          strength.friction_now(residual),
          residual ? strength.residual_cohesion : 0,
          strength.dilation,
          strength.dilation_slip,
          side * trial.slip[e]};
}

// Where the slope of the rise changes next, m of slip; `end.way` where it does not any more.
double next_corner(const RisingEnd& end, double slip) {
  double next = end.way;
  for (const double corner : {-end.reach, 0.0, end.reach}) {
    const double there = corner - end.before;
    if (there > slip) next = std::min(next, there);
  }
  return next;
}

// On a stretch of one slope, at the end of which the end carries more than the spring has: the slip where both agree.
double slip_within(const RisingEnd& end, double from, double slope) {
  const double pressed = end.normal_stiffness * (end.rise(from) - slope * from - end.normal_gap);  // and slope * slip
  const double yielding = end.shear_stiffness * end.way - end.cohesion - end.friction * pressed;
  const double slip = yielding / (end.shear_stiffness + end.friction * end.normal_stiffness * slope);
  return std::clamp(slip, from, end.way);
}

double slip_of(const RisingEnd& end) {
  double from = 0;
  while (from < end.way) {
    const double to = next_corner(end, from);
    if (end.beyond(to) <= 0) {
      const double slip = slip_within(end, from, end.slope_after(from));
      return end.pressure(slip) > 0 ? slip : end.way;
    }
    from = to;
  }
  return end.way;
}

void answer_open(int end, InterfaceTrial& trial) {
  trial.force.segment<2>(2 * end).setZero();
  trial.active.segment<2>(2 * end).setZero();
  trial.dilation[static_cast<std::size_t>(end)] = 0;
  trial.capacity[static_cast<std::size_t>(end)] = 0;
}

// Rows of a joint that slips as steeply as it rises.
void set_rows(const InterfaceSprings& springs, const RisingEnd& at, double slope, double side, int end,
              InterfaceTrial& trial) {
  const double stiffness = at.normal_stiffness * at.shear_stiffness / at.resistance(slope);
  trial.active(2 * end) = stiffness / springs.stiffness(2 * end);
  trial.active(2 * end + 1) = 0;
  if (slope <= 0 || ends_of(springs) > 1) return;
  trial.coupling = -side * slope * stiffness;
  trial.active(1) = std::min(slope * slope * stiffness / springs.stiffness(1), end_answer::steepest_slip);
}

}  // namespace

bool rides_up(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end) {
  const ContactRule& rule = trial.rule;
  if (strength.dilation == 0 || rule.sticks || rule.conserves_energy || rule.capacity_is_given) return false;
  const auto e = static_cast<std::size_t>(end);
  return trial.broken[e] && !trial.closes[e] && springs.law == InterfaceLaw::classical;
}

void respond_riding(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial) {
  const auto e = static_cast<std::size_t>(end);
  const double side = side_of(springs, trial, end);
  const RisingEnd at = end_of(springs, strength, trial, end, side);
  const double pressure = at.pressure(0);
  const double stuck = at.shear_stiffness * at.way;
  if (pressure > 0 && stuck < (1 - end_answer::at_capacity) * at.capacity(pressure)) {
    trial.dilation[e] = 0;
    trial.capacity[e] = at.capacity(pressure);
    trial.force.segment<2>(2 * end) = Vec2(-pressure, side * stuck);
    trial.active(2 * end) = at.normal_stiffness / springs.stiffness(2 * end);
    trial.active(2 * end + 1) = at.shear_stiffness / springs.stiffness(2 * end + 1);
    return;
  }
  const double slip = slip_of(at);
  const double pressed = at.pressure(slip);
  if (pressed == 0) answer_open(end, trial);
  // A dashpot can take all that a spring presses with while the end is still closed: then it slides, and rises.
  const bool is_closed = trial.gap(2 * end) < at.rise(slip);
  if (pressed > 0 || is_closed) trial.dilation[e] = at.rise(slip);
  if (pressed == 0) return;
  trial.capacity[e] = at.capacity(pressed);
  trial.force.segment<2>(2 * end) = Vec2(-pressed, side * trial.capacity[e]);
  set_rows(springs, at, at.slope_after(slip), side, end, trial);
}

void take_riding_rows(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial) {
  const double side = side_of(springs, trial, end);
  const RisingEnd at = end_of(springs, strength, trial, end, side);
  set_rows(springs, at, at.slope_after(0), side, end, trial);
}

Mat2 slopes_beyond_rows(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                        int end, double side) {
  const RisingEnd at = end_of(springs, strength, trial, end, side);
  const double slip = std::max(0.0, at.way - side * trial.force(2 * end + 1) / at.shear_stiffness);
  const double slope = at.slope_after(slip);
  const double stiffness = at.normal_stiffness * at.shear_stiffness / at.resistance(slope);
  Mat2 slopes;
  slopes << stiffness, -side * slope * stiffness,  //
      -side * at.friction * stiffness, at.friction * slope * stiffness;
  slopes(0, 0) -= trial.active(2 * end) * springs.stiffness(2 * end);
  slopes(1, 1) -= trial.active(2 * end + 1) * springs.stiffness(2 * end + 1);
  if (ends_of(springs) > 1) return slopes;
  slopes(0, 1) -= trial.coupling;
  slopes(1, 0) -= trial.coupling;
  return slopes;
}

}  // namespace dda
