#include "engine/contact/open_close.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/contact/bed_in_step.h"
#include "engine/contact/bond_strength.h"
#include "engine/contact/end_answer.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/rising_end.h"
#include "engine/contact/sticking.h"

namespace dda {
namespace {

using namespace end_answer;
using namespace sticking;

Eigen::Index normal_row(int end) { return 2 * end; }

Vec2 normal_gaps(const InterfaceTrial& trial) { return {trial.normal_gap(0), trial.normal_gap(1)}; }

double capacity_of(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial, int end) {
  if (trial.rule.sticks) return touched(springs, trial, end) ? std::numeric_limits<double>::infinity() : 0;
  if (springs.law == InterfaceLaw::projected) return stretch_capacity(springs, strength, trial, end);
  const bool residual = trial.residual[static_cast<std::size_t>(end)];
  const double force = trial.force(normal_row(end));
  if (!trial.rule.conserves_energy) return strength.capacity(force, residual);
  return 2 * strength.capacity((force + trial.before(normal_row(end))) / 2, residual);
}

void respond_normal(const InterfaceSprings& springs, int end, InterfaceTrial& trial) {
  const Eigen::Index n = normal_row(end);
  const Answer answer = press(trial.rule, row_of(springs, trial, n), trial.normal_gap(end));
  trial.force(n) = answer.force;
  trial.active(n) = answer.slope;
}

void press_on_bed(const InterfaceSprings& springs, InterfaceTrial& trial) {
  const BedAnswer bed = answer_of_bed(springs, trial, normal_gaps(trial));
  for (const int end : {0, 1}) {
    trial.force(normal_row(end)) = bed.force(end);
    trial.active(normal_row(end)) = bed.slope(end) / springs.stiffness(0);
  }
  trial.coupling = bed.coupling;
}

void respond_normals(const InterfaceSprings& springs, InterfaceTrial& trial) {
  if (press_together(springs, trial.broken)) {
    press_on_bed(springs, trial);
    return;
  }
  for (int end = 0; end < ends_of(springs); ++end) respond_normal(springs, end, trial);
}

void respond_tangent(const InterfaceSprings& springs, int end, InterfaceTrial& trial) {
  const Eigen::Index t = normal_row(end) + 1;
  const Answer answer = shear(row_of(springs, trial, t), trial.gap(t), trial, static_cast<std::size_t>(end));
  trial.force(t) = answer.force;
  trial.active(t) = answer.slope;
}

void set_capacity(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end)
    trial.capacity[static_cast<std::size_t>(end)] = capacity_of(springs, strength, trial, end);
}

void follow_pressure(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  respond_normals(springs, trial);
  set_capacity(springs, strength, trial);
  for (int end = 0; end < ends_of(springs); ++end) respond_tangent(springs, end, trial);
}

// The normal forces of the springs alone.
Vec2 normals_of_springs(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  if (press_together(springs, trial.broken)) return press_bed(bed_of(springs), normal_gaps(trial)).force;
  Vec2 force = Vec2::Zero();
  for (int end = 0; end < ends_of(springs); ++end) {
    const Row normal = row_of(springs, trial, normal_row(end));
    force(end) = spring(trial.rule, normal.stiffness, normal.start, trial.normal_gap(end)).force;
  }
  return force;
}

bool slides(const InterfaceTrial& trial, int end) {
  return trial.broken[static_cast<std::size_t>(end)] && trial.normal_gap(end) < 0 &&
         trial.active(normal_row(end) + 1) < 1;
}

// How far the slider in line with spring and dashpot, which lie side by side, has gone where they bear `force` alone.
double yielded(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Row row = row_of(springs, trial, normal_row(end) + 1);
  const double beyond = stuck_force(row, trial.gap(normal_row(end) + 1)) - trial.force(normal_row(end) + 1);
  return elastic_gap(beyond, row.stiffness + row.dashpot, 0);
}

// What the spring of an end that slides keeps of its shear. Beside a dashpot it is less than the friction: what the
// dashpot bears of that comes to nothing when the step ends, and a spring that took it over would be stretched against
// the way of the slip, with energy from nowhere.
double shear_kept(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Eigen::Index row = normal_row(end) + 1;
  if (!trial.rule.conserves_energy) {
    if (springs.dashpot(row) == 0) return trial.force(row);
    return springs.stiffness(row) * (trial.gap(row) - yielded(springs, trial, end));
  }
  const double friction = trial.capacity[static_cast<std::size_t>(end)] / 2;
  return std::clamp(springs.stiffness(row) * trial.gap(row), -friction, friction);
}

// In a conserving step an end slips when its spring ends the step beyond its friction, even if the mean never was.
bool slips(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  if (trial.active(normal_row(end) + 1) < 1) return true;
  if (!trial.rule.conserves_energy || trial.rule.sticks || !trial.broken[static_cast<std::size_t>(end)]) return false;
  const Eigen::Index row = normal_row(end) + 1;
  return shear_kept(springs, trial, end) != springs.stiffness(row) * trial.gap(row);
}

// Slip of a sliding end within the step.
double slip_in_step(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Eigen::Index row = normal_row(end) + 1;
  return trial.gap(row) - elastic_gap(shear_kept(springs, trial, end), springs.stiffness(row), trial.gap(row));
}

// What the capacity gains for each metre of slip where every metre of rise presses by `stiffness` more.
double hardening_by(double stiffness, const EndStrength& strength, const InterfaceTrial& trial, std::size_t end,
                    double slip) {
  if (std::abs(slip) >= strength.dilation_slip) return 0;
  return strength.friction_now(trial.residual[end]) * strength.dilation * stiffness;
}

void expect_full_stiffness(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (trial.closes[e]) continue;
    trial.hardening[e] = hardening_by(springs.stiffness(normal_row(end)), strength, trial, e, trial.slip[e]);
  }
}

// Ends that are open, or whose friction is given, do not rise in the step; all come down by what they owe.
void prepare_rise(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    trial.dilation[e] = -trial.owed[e];
    trial.closes[e] = trial.rule.capacity_is_given || (trial.broken[e] && trial.start(normal_row(end)) > 0);
  }
  if (!trial.rule.sticks) expect_full_stiffness(springs, strength, trial);
}

// An end that slid in the last step starts this one at its capacity, but for round-off and the gap measured anew: the
// first pass takes it to slide on.
void keep_sliding(const InterfaceSprings& springs, const InterfaceState& start, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index row = normal_row(end) + 1;
    if (start.status[e] != ContactStatus::sliding || trial.capacity[e] == 0 || trial.rule.sticks) continue;
    trial.force(row) = std::copysign(trial.capacity[e], start.gap(row)) - trial.before(row);
    const double hardening = yield_of(trial, e, std::copysign(1, start.gap(row))).hardening;
    trial.active(row) = hardening > 0 ? hardening / (springs.stiffness(row) + hardening) : 0;
  }
}

// Such an end is on its way up, or down, from the first pass on.
void keep_riding(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& start,
                 InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (start.status[e] == ContactStatus::sliding && trial.capacity[e] > 0 && rides_up(springs, strength, trial, end))
      take_riding_rows(springs, strength, end, trial);
  }
}

// A stretch on a bed that just touches has no capacity yet, and has one as soon as it presses: the first pass takes it
// to stick, or blocks that are stacked without force would fly off sideways in it.
void stick_where_touching(const InterfaceSprings& springs, InterfaceTrial& trial) {
  if (!press_together(springs, trial.broken) || trial.active(0) == 0 || trial.force(0) != 0 || trial.force(2) != 0)
    return;
  for (int end = 0; end < ends_of(springs); ++end) respond_as_stuck(springs, end, trial);
}

// A broken bond of one end has failed, whichever way; a dry end when it slides, if that makes a difference.
bool has_failed(const EndStrength& strength, const InterfaceTrial& trial, int end) {
  return !strength.is_dry() || (strength.friction_drop > 0 && slides(trial, end));
}

}  // namespace

InterfaceTrial start_trial(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceState& start,
                           const ContactRule& rule) {
  InterfaceTrial trial;
  trial.start = trial.gap = start.gap;
  trial.broken = start.broken;
  trial.residual = start.residual;
  trial.torn = start.torn;
  trial.slip = start.slip;
  trial.force = start.force;
  trial.rule = rule;
  if (has_stress_rows(springs)) return trial;
  if (rule.sticks) close_where_touching(springs, trial);
  for (int end = 0; end < ends_of(springs); ++end)
    if (rule.conserves_energy && trial.broken[static_cast<std::size_t>(end)])
      trial.before.segment<2>(normal_row(end)) = start.force.segment<2>(normal_row(end));
  if (strength.dilation > 0) trial.owed = height_owed(springs, strength, start);
  if (strength.dilation > 0) prepare_rise(springs, strength, trial);
  follow_pressure(springs, strength, trial);  // at the gap that the step begins with, what is foreseen included
  keep_sliding(springs, start, trial);
  if (strength.dilation > 0) keep_riding(springs, strength, start, trial);
  stick_where_touching(springs, trial);
  return trial;
}

void respond(const InterfaceSprings& springs, InterfaceTrial& trial) {
  respond_normals(springs, trial);
  for (int end = 0; end < ends_of(springs); ++end) respond_tangent(springs, end, trial);
}

void respond_as_stuck(const InterfaceSprings& springs, int end, InterfaceTrial& trial) {
  const Eigen::Index t = normal_row(end) + 1;
  const Row row = row_of(springs, trial, t);
  trial.force(t) = stuck_force(row, trial.gap(t));
  trial.active(t) = stuck_slope(row);
}

// Where the joint dilates: ends that ride up as rising_end.h has it, the others as they answer without.
static void respond_with_dilation(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  trial.coupling = 0;
  respond(springs, trial);
  update_capacity(springs, strength, trial);
  for (int end = 0; end < ends_of(springs); ++end)
    if (rides_up(springs, strength, trial, end)) respond_riding(springs, strength, end, trial);
}

void respond_with_friction(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  if (trial.rule.sticks) let_go_of_opening(springs, trial);
  if (trial.rule.capacity_is_given) return respond(springs, trial);
  if (strength.dilation > 0) return respond_with_dilation(springs, strength, trial);
  follow_pressure(springs, strength, trial);
}

double force_along(const InterfaceSprings& springs, const InterfaceTrial& trial, double t) {
  double along = 0;
  const bool on_bed = press_together(springs, trial.broken);
  if (on_bed) {
    const Vec2 turn(trial.direction(0), trial.direction(2));
    along = turn.dot(answer_of_bed(springs, trial, normal_gaps(trial) + t * turn).force);
  }
  for (int end = 0; end < ends_of(springs); ++end) {
    const Eigen::Index n = normal_row(end);
    const double gap = trial.normal_gap(end) + t * trial.direction(n);
    const double slide = trial.gap(n + 1) + t * trial.direction(n + 1);
    if (!on_bed) along += trial.direction(n) * press(trial.rule, row_of(springs, trial, n), gap).force;
    along += trial.direction(n + 1) *
             shear(row_of(springs, trial, n + 1), slide, trial, static_cast<std::size_t>(end)).force;
  }
  return along;
}

double update_capacity(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  const Vec4 before = trial.force;
  if (trial.rule.sticks) let_go_of_opening(springs, trial);
  if (!trial.rule.capacity_is_given) set_capacity(springs, strength, trial);
  respond(springs, trial);
  return (trial.force - before).cwiseAbs().maxCoeff();
}

double update_dilation(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  if (strength.dilation == 0 || trial.rule.sticks) return 0;
  const Vec4 before = trial.force;
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (trial.closes[e]) continue;
    const double full = springs.stiffness(normal_row(end));
    const double force = trial.force(normal_row(end));
    const double seen = trial.rise[e] == 0 ? full : std::clamp((trial.pressed[e] - force) / trial.rise[e], 0.0, full);
    const bool has_slipped = trial.rule.conserves_energy ? slips(springs, trial, end) : slides(trial, end);
    const double slip = has_slipped ? slip_in_step(springs, trial, end) : 0;
    const double dilation = rise_in_step(springs, strength, trial, end, slip);
    const bool may_yield = slip != 0 || trial.rule.conserves_energy;  // the mean, where the spring has not slipped
    trial.reference[e] = may_yield ? yielded(springs, trial, end) : 0;
    trial.hardening[e] = hardening_by(seen, strength, trial, e, trial.slip[e] + slip);
    trial.rise[e] = dilation - trial.dilation[e];
    trial.pressed[e] = force;
    trial.dilation[e] = dilation;
  }
  respond(springs, trial);
  return (trial.force - before).cwiseAbs().maxCoeff();
}

void forget_rise(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  if (strength.dilation == 0) return;
  for (std::array<double, 2>* each : {&trial.reference, &trial.rise, &trial.pressed}) *each = {0, 0};
  trial.coupling = 0;
  prepare_rise(springs, strength, trial);
}

bool break_ends(const InterfaceSprings& springs, const EndStrength& strength, InterfaceTrial& trial) {
  if (trial.rule.sticks) return false;
  if (springs.law == InterfaceLaw::projected) return break_stretch(springs, strength, trial);
  bool broke = false;
  for (int end = 0; end < 2; ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    if (!trial.broken[e] && exceeds(strength, trial.force(n), trial.force(n + 1))) trial.broken[e] = broke = true;
    if (trial.broken[e] && !trial.residual[e] && has_failed(strength, trial, end)) trial.residual[e] = broke = true;
  }
  return broke;
}

Vec4 dashpot_force(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  Vec4 force = Vec4::Zero();
  if (!has_dashpots(springs, trial)) return force;
  const Vec2 of_springs = normals_of_springs(springs, trial);
  const bool presses_as_one = press_together(springs, trial.broken) && !of_springs.isZero(0);
  for (int end = 0; end < ends_of(springs); ++end) {
    const Eigen::Index n = normal_row(end);
    const Row normal = row_of(springs, trial, n);
    const Row tangent = row_of(springs, trial, n + 1);
    if (!normal.broken) continue;
    force(n) = trial.force(n) - of_springs(end);
    if (trial.active(n + 1) >= 1)
      force(n + 1) = tangent.dashpot * (trial.gap(n + 1) - tangent.start);
    else if (!trial.rule.conserves_energy && (trial.normal_gap(end) < 0 || presses_as_one))
      force(n + 1) = trial.force(n + 1) - shear_kept(springs, trial, end);
  }
  return force;
}

bool release_shear(const InterfaceSprings& springs, const EndStrength& strength, InterfaceState& state) {
  if (has_stress_rows(springs)) return false;
  bool released = false;
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    const double capacity = springs.law == InterfaceLaw::projected
                                ? stretch_capacity(springs, strength, state, end)
                                : strength.capacity(state.force(n), state.residual[e]);
    if (!state.broken[e] || std::abs(state.force(n + 1)) <= capacity) continue;
    state.force(n + 1) = std::copysign(capacity, state.force(n + 1));
    const double left = elastic_gap(state.force(n + 1), springs.stiffness(n + 1), state.gap(n + 1));
    state.slip[e] += state.gap(n + 1) - left;
    state.gap(n + 1) = left;
    state.status[e] = ContactStatus::sliding;
    released = true;
  }
  return released;
}

// The ends of a projected stretch that gape, while the rest presses. They carry no shear, as it has no capacity.
void note_open_ends(const InterfaceSprings& springs, const InterfaceTrial& trial, InterfaceState& state) {
  const OpenEnds open = open_ends(springs.lever, normal_gaps(trial));
  if (open.first) state.status[0] = ContactStatus::open;
  if (open.second) state.status[1] = ContactStatus::open;
}

InterfaceState finish_trial(const InterfaceSprings& springs, const InterfaceState& start, const InterfaceTrial& trial) {
  InterfaceState state = start;
  state.gap = trial.gap;
  state.force = trial.force;
  state.broken = trial.broken;
  state.residual = trial.residual;
  if (has_stress_rows(springs)) return state;
  const bool on_bed = press_together(springs, trial.broken);
  if (on_bed && (has_dashpots(springs, trial) || trial.rule.conserves_energy)) {
    const Vec2 of_springs = normals_of_springs(springs, trial);
    state.force(0) = of_springs(0);
    state.force(2) = of_springs(1);
  }
  const bool presses = presses_together(springs, trial.broken, state.force);
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    state.gap(n) = trial.normal_gap(end);
    state.dilation[e] += trial.dilation[e];
    if (trial.broken[e] && !on_bed) state.force(n) = springs.stiffness(n) * pressed(state.gap(n));
    if (on_bed ? !presses : trial.broken[e] && state.gap(n) >= 0) {
      state.status[e] = ContactStatus::open;
      state.force.segment<2>(n).setZero();
      // While it was still closed.
      if (trial.has_ridden(e)) state.slip[e] += slip_in_step(springs, trial, end);
      state.gap(n + 1) = 0;  // a joint that closes again starts without shear
      continue;
    }
    const bool slid = slips(springs, trial, end);
    state.status[e] = slid ? ContactStatus::sliding : ContactStatus::locked;
    if (!slid) {
      state.force(n + 1) = springs.stiffness(n + 1) * trial.gap(n + 1);
      continue;
    }
    state.force(n + 1) = shear_kept(springs, trial, end);
    state.gap(n + 1) = elastic_gap(state.force(n + 1), springs.stiffness(n + 1), trial.gap(n + 1));
    if (!trial.closes[e]) state.slip[e] += trial.gap(n + 1) - state.gap(n + 1);
  }
  if (presses) note_open_ends(springs, trial, state);
  return state;
}

}  // namespace dda
