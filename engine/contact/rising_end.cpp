#include "engine/contact/rising_end.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/contact/end_answer.h"

namespace dda {
namespace {

// The share of the shear spring that is left at least of its stiffness and of what pressure gains by slip together.
constexpr double least_share = 0.25;

struct Press {
  double pressure;   // N per m of thickness
  double stiffness;  // N/m per m of thickness: how much more it is when the normal gap is less
};

// What presses under integrators that conserve energy: the mean of the step.
struct MeanPress {
  ContactRule rule;
  end_answer::Row row;
  double before;  // N per m of thickness, the normal force at the start of the step

  [[nodiscard]] Press at(double normal_gap) const {
    const end_answer::Answer answer = end_answer::press(rule, row, normal_gap);
    return {-(answer.force + before) / 2, answer.slope * row.stiffness / 2};
  }
};

// What an end is and where it is. Slips count towards the side that the tangential gap is on.
struct RisingEnd {
  double normal_stiffness, shear_stiffness;  // N/m per m of thickness, of spring and dashpot together
  double normal_gap, way;                    // m, without what it rides up in the step; and the size of the tangential
  double friction, cohesion;
  double tangent, reach;  // of the dilation angle; m, slip beyond which it rises no further
  double before;          // m, slip before the step: negative on the way back
  double owed;            // m, from steps before
  bool is_late;           // it comes down by this step's way back in the next
  std::optional<MeanPress> mean;

  [[nodiscard]] double rise(double slip) const { return tangent * (ridden(before + slip) - ridden(before)) - owed; }
  [[nodiscard]] Press press(double slip) const {
    if (mean) return mean->at(normal_gap - rise(slip));
    return {normal_stiffness * std::max(0.0, rise(slip) - normal_gap), normal_stiffness};
  }
  [[nodiscard]] double pressure(double slip) const { return press(slip).pressure; }
  [[nodiscard]] double capacity(double pressure) const { return pressure > 0 ? cohesion + friction * pressure : 0; }
  // Shear of the spring beyond what the end carries: 0 at the slip sought.
  [[nodiscard]] double beyond(double slip) const { return shear_stiffness * (way - slip) - capacity(pressure(slip)); }
  // The slip that counts for the rise, where the way back does not.
  [[nodiscard]] double ridden(double total) const {
    return std::min(is_late ? std::max(total, 0.0) : std::abs(total), reach);
  }
  // Rise by slip from there on.
  [[nodiscard]] double slope_after(double slip) const {
    const double total = before + slip;
    if (total >= 0) return total < reach ? tangent : 0;
    return total >= -reach && !is_late ? -tangent : 0;
  }
  // Slope of the shear force over the slip with its sign turned: above 0 where more slip is resisted.
  [[nodiscard]] double resistance(double slope, double by_normal_gap) const {
    return std::max(shear_stiffness + friction * by_normal_gap * slope, least_share * shear_stiffness);
  }
  // Pressure that is left, for each metre of normal gap, when the slip has followed.
  [[nodiscard]] double softened(double slope, double by_normal_gap) const {
    return by_normal_gap * shear_stiffness / resistance(slope, by_normal_gap);
  }
};

// The force of the balance, which means make of that of the start and of this one, changes twice as much as the mean.
double forces_per_pressure(const InterfaceTrial& trial) { return trial.rule.conserves_energy ? 2 : 1; }

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
  if (trial.rule.conserves_energy) return std::copysign(1, trial.gap(row));
  return std::copysign(1, together(springs, trial, row, trial.start(row)).gap);
}

// Whether an end whose slip brings it down has less than `least_share` of its shear spring to resist with.
bool comes_down_late(const InterfaceSprings& springs, const EndStrength& strength, bool residual, int end) {
  const double let_go = strength.friction_now(residual) * strength.dilation * springs.stiffness(2 * end);
  return let_go > (1 - least_share) * springs.stiffness(2 * end + 1);
}

RisingEnd end_of(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end,
                 double side) {
  const auto e = static_cast<std::size_t>(end);
  const bool residual = trial.residual[e];
  const Eigen::Index n = 2 * end;
  const bool in_mean = trial.rule.conserves_energy;  // what is left in springs is no affair of dashpots then
  const auto of_row = [&](Eigen::Index row, double start) {
    return in_mean ? SpringWithDashpot{springs.stiffness(row), trial.gap(row)} : together(springs, trial, row, start);
  };
  const SpringWithDashpot normal = of_row(n, end_answer::pressed(trial.start(n)));
  const SpringWithDashpot shear = of_row(n + 1, trial.start(n + 1));
  return {normal.stiffness,
          shear.stiffness,
          normal.gap,
          side * shear.gap,
          strength.friction_now(residual),
          residual ? strength.residual_cohesion : 0,
          strength.dilation,
          strength.dilation_slip,
          side * trial.slip[e],
          trial.owed[e],
          comes_down_late(springs, strength, residual, end),
          in_mean ? std::optional(MeanPress{trial.rule, end_answer::row_of(springs, trial, n), trial.before(n)})
                  : std::nullopt};
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

// What the spring has beyond what the end carries is concave in the slip where means press: from a slip at which it is
// less, Newton's method comes down to the one sought without passing it.
double slip_below(const RisingEnd& end, double from, double to, double slope) {
  constexpr int most_steps = 60;
  double slip = to;
  for (int i = 0; i < most_steps; ++i) {
    const Press press = end.press(slip);
    const double by_slip = end.shear_stiffness + end.friction * press.stiffness * slope;
    const double next = std::max(from, slip + end.beyond(slip) / by_slip);
    if (!(next < slip)) break;
    slip = next;
  }
  return slip;
}

// On a stretch of one slope, at the end of which the end carries more than the spring has: the slip where both agree.
double slip_within(const RisingEnd& end, double from, double to) {
  const double slope = end.slope_after(from);
  if (end.mean) return slip_below(end, from, to, slope);
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
      const double slip = slip_within(end, from, to);
      return end.pressure(slip) > 0 ? slip : end.way;
    }
    from = to;
  }
  return end.way;
}

void answer_open(int end, InterfaceTrial& trial) {
  trial.force.segment<2>(2 * end).setZero();
  trial.active.segment<2>(2 * end).setZero();
  trial.dilation[static_cast<std::size_t>(end)] = -trial.owed[static_cast<std::size_t>(end)];
  trial.capacity[static_cast<std::size_t>(end)] = 0;
}

// The slip that the forces of an end which slides to `side` belong to.
double slip_reached(const RisingEnd& at, const InterfaceTrial& trial, int end, double side) {
  const double shear = at.mean ? trial.capacity[static_cast<std::size_t>(end)] / 2 : side * trial.force(2 * end + 1);
  return std::max(0.0, at.way - shear / at.shear_stiffness);
}

// Before the first pass an end that slid in the last step is taken to slide on, though it has not yet.
bool is_at_start(const InterfaceTrial& trial, int end) {
  return trial.gap.segment<2>(2 * end) == trial.start.segment<2>(2 * end);
}

// Rows of a joint that slips as steeply as it rises, after a slip.
void set_rows(const InterfaceSprings& springs, const RisingEnd& at, double slip, double side, int end,
              InterfaceTrial& trial) {
  const double slope = at.slope_after(slip);
  const double stiffness = forces_per_pressure(trial) * at.softened(slope, at.press(slip).stiffness);
  trial.active(2 * end) = stiffness / springs.stiffness(2 * end);
  trial.active(2 * end + 1) = 0;
  if (slope <= 0 || ends_of(springs) > 1) return;
  trial.coupling = -side * slope * stiffness;
  trial.active(1) = std::min(slope * slope * stiffness / springs.stiffness(1), end_answer::steepest_slip);
}

// The mean of the shear, with that of the start, is at most the friction of the mean pressure.
bool shear_in_mean(const InterfaceSprings& springs, int end, InterfaceTrial& trial) {
  const Eigen::Index row = 2 * end + 1;
  const end_answer::Row spring = end_answer::row_of(springs, trial, row);
  const double capacity = trial.capacity[static_cast<std::size_t>(end)];
  const double stuck = end_answer::stuck_force(spring, trial.gap(row));
  const double both = stuck + trial.before(row);
  const bool sticks = std::abs(both) < (1 - end_answer::at_capacity) * capacity;
  trial.force(row) = sticks ? stuck : std::copysign(capacity, both) - trial.before(row);
  trial.active(row) = sticks ? end_answer::stuck_slope(spring) : 0;
  return !sticks;
}

// The same under integrators that conserve energy.
void respond_riding_in_mean(const InterfaceSprings& springs, const RisingEnd& at, int end, double side,
                            InterfaceTrial& trial) {
  const auto e = static_cast<std::size_t>(end);
  const double slip = at.beyond(0) > 0 ? slip_of(at) : 0;
  trial.dilation[e] = at.rise(slip);
  trial.capacity[e] = 2 * at.capacity(at.pressure(slip));
  const end_answer::Row normal = end_answer::row_of(springs, trial, 2 * end);
  const end_answer::Answer pressed = end_answer::press(trial.rule, normal, trial.normal_gap(end));
  trial.force(2 * end) = pressed.force;
  trial.active(2 * end) = pressed.slope;
  const bool slides = shear_in_mean(springs, end, trial);
  if (slip == 0) return;
  const double stuck = trial.active(2 * end + 1);
  set_rows(springs, at, slip, side, end, trial);
  if (slides) return;
  trial.active(2 * end + 1) = stuck;
  if (ends_of(springs) == 1) trial.coupling = 0;
}

}  // namespace

bool rides_up(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end) {
  const ContactRule& rule = trial.rule;
  if (strength.dilation == 0 || rule.sticks || rule.capacity_is_given) return false;
  const auto e = static_cast<std::size_t>(end);
  return trial.broken[e] && !trial.closes[e] && springs.law == InterfaceLaw::classical;
}

std::array<double, 2> height_owed(const InterfaceSprings& springs, const EndStrength& strength,
                                  const InterfaceState& state) {
  std::array<double, 2> owed{0, 0};
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (state.broken[e] && comes_down_late(springs, strength, state.residual[e], end))
      owed[e] = std::max(0.0, state.dilation[e] - strength.lift(state.slip[e]));
  }
  return owed;
}

double rise_in_step(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end,
                    double slip) {
  const auto e = static_cast<std::size_t>(end);
  const bool is_late = comes_down_late(springs, strength, trial.residual[e], end);
  const double side = std::copysign(1, slip);
  const auto ridden = [&](double total) { return is_late ? std::max(side * total, 0.0) : total; };
  return strength.lift(ridden(trial.slip[e] + slip)) - strength.lift(ridden(trial.slip[e])) - trial.owed[e];
}

void respond_riding(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial) {
  const auto e = static_cast<std::size_t>(end);
  const double side = side_of(springs, trial, end);
  const RisingEnd at = end_of(springs, strength, trial, end, side);
  if (at.mean) return respond_riding_in_mean(springs, at, end, side, trial);
  const double pressure = at.pressure(0);
  const double stuck = at.shear_stiffness * at.way;
  if (pressure > 0 && stuck < (1 - end_answer::at_capacity) * at.capacity(pressure)) {
    trial.dilation[e] = at.rise(0);
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
  set_rows(springs, at, slip, side, end, trial);
}

void take_riding_rows(const InterfaceSprings& springs, const EndStrength& strength, int end, InterfaceTrial& trial) {
  const double side = side_of(springs, trial, end);
  const RisingEnd at = end_of(springs, strength, trial, end, side);
  set_rows(springs, at, 0, side, end, trial);
}

Mat2 slopes_beyond_rows(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                        int end, double side) {
  // The mean of the shear may point against what the spring is left with, and then nothing rises.
  const double risen_to = trial.rule.conserves_energy ? side_of(springs, trial, end) : side;
  const RisingEnd at = end_of(springs, strength, trial, end, risen_to);
  const double slip = slip_reached(at, trial, end, side);
  const bool rises = !at.mean || slip > 0 || is_at_start(trial, end);
  const double slope = rises ? at.slope_after(slip) : 0;
  const double stiffness = forces_per_pressure(trial) * at.softened(slope, at.press(slip).stiffness);
  Mat2 slopes;
  slopes << stiffness, -risen_to * slope * stiffness,  //
      -side * at.friction * stiffness, side * risen_to * at.friction * slope * stiffness;
  const bool sticks = trial.active(2 * end + 1) >= 1;
  if (sticks) slopes.row(1) << 0, trial.active(2 * end + 1) * springs.stiffness(2 * end + 1);
  slopes(0, 0) -= trial.active(2 * end) * springs.stiffness(2 * end);
  slopes(1, 1) -= trial.active(2 * end + 1) * springs.stiffness(2 * end + 1);
  if (ends_of(springs) > 1) return slopes;
  slopes(0, 1) -= trial.coupling;
  slopes(1, 0) -= trial.coupling;
  return slopes;
}

}  // namespace dda
