#include "dda/contact/open_close.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dda {
namespace {

constexpr double at_capacity = 1e-12;

struct Answer {
  double force;
  double slope;  // over the stiffness
};

double pressed(double gap) { return std::min(0.0, gap); }

// The spring's part of the balance that makes its work the change of its energy; see the header.
Answer conserving_spring(double stiffness, double start, double gap) {
  if (start < 0 && gap < 0) return {stiffness * gap, 1};
  if (start >= 0 && gap >= 0) return {0, 0};
  const double share = std::min(start, gap) / -std::abs(gap - start);  // of the way that lies in contact
  return {stiffness * gap * share, start < 0 ? share * share : share * (2 - share)};
}

Answer spring(const ContactRule& rule, double stiffness, double start, double gap) {
  if (rule.conserves_energy) return conserving_spring(stiffness, start, gap);
  return gap >= 0 ? Answer{0, 0} : Answer{stiffness * gap, 1};
}

struct Row {
  double stiffness;
  double dashpot;  // N/m: dashpot * rate
  double start;    // gap at the start of the step
  bool broken;
};

Answer press(const ContactRule& rule, const Row& row, double gap) {
  if (!row.broken) return {row.stiffness * gap, 1};
  const Answer elastic = spring(rule, row.stiffness, row.start, gap);
  if (row.dashpot == 0) return elastic;
  // Spring and dashpot together do not pull: in the balance of means, together with the force of the start.
  const double no_pull = rule.conserves_energy ? -row.stiffness * pressed(row.start) : 0;
  const double both = elastic.force + row.dashpot * (pressed(gap) - pressed(row.start));
  if (both >= no_pull) return {no_pull, 0};
  return {both, elastic.slope + (gap < 0 ? row.dashpot / row.stiffness : 0)};
}

Answer shear(const Row& row, double gap, double capacity) {
  const double dashpot = row.broken ? row.dashpot : 0;
  const double stuck = row.stiffness * gap + dashpot * (gap - row.start);
  // A joint that slid in the last step starts this one right at its capacity: it slides on unless it turns back.
  if (row.broken && std::abs(stuck) >= (1 - at_capacity) * capacity) return {std::copysign(capacity, stuck), 0};
  return {stuck, 1 + (dashpot > 0 ? dashpot / row.stiffness : 0)};
}

Row row_of(const InterfaceElement& element, const InterfaceTrial& trial, Eigen::Index row) {
  return {element.stiffness(row), element.dashpot(row) * trial.rule.dashpot_rate, trial.start(row),
          trial.broken[static_cast<std::size_t>(row / 2)]};
}

int ends_of(const InterfaceElement& element) { return element.length > 0 ? 2 : 1; }

Eigen::Index normal_row(int end) { return 2 * end; }

// Capacity of an end: friction times the force that presses it.
double capacity_of(const EndStrength& strength, const InterfaceTrial& trial, int end) {
  const Eigen::Index n = normal_row(end);
  if (trial.rule.sticks) return trial.start(n) <= trial.rule.touching ? std::numeric_limits<double>::infinity() : 0;
  return strength.friction * std::max(0.0, -trial.force(n));
}

void set_capacity(const InterfaceElement& element, const EndStrength& strength, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end)
    trial.capacity[static_cast<std::size_t>(end)] = capacity_of(strength, trial, end);
}

// An end that slid in the last step starts this one at its capacity, but for round-off and the gap measured anew: the
// first pass takes it to slide on.
void keep_sliding(const InterfaceElement& element, const InterfaceState& start, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index row = normal_row(end) + 1;
    if (start.status[e] != ContactStatus::sliding || trial.capacity[e] == 0 || trial.rule.sticks) continue;
    trial.force(row) = std::copysign(trial.capacity[e], start.gap(row));
    trial.active(row) = 0;
  }
}

}  // namespace

InterfaceTrial start_trial(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& start,
                           const ContactRule& rule) {
  InterfaceTrial trial;
  trial.start = trial.gap = start.gap;
  trial.broken = start.broken;
  trial.force = start.force;
  trial.rule = rule;
  if (has_stress_rows(element)) return trial;
  set_capacity(element, strength, trial);  // by the forces of the start
  respond(element, trial);
  keep_sliding(element, start, trial);
  return trial;
}

void respond(const InterfaceElement& element, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end) {
    const Eigen::Index n = normal_row(end);
    const Answer normal = press(trial.rule, row_of(element, trial, n), trial.gap(n));
    const Answer tangent =
        shear(row_of(element, trial, n + 1), trial.gap(n + 1), trial.capacity[static_cast<std::size_t>(end)]);
    trial.force.segment<2>(n) << normal.force, tangent.force;
    trial.active.segment<2>(n) << normal.slope, tangent.slope;
  }
}

double force_along(const InterfaceElement& element, const InterfaceTrial& trial, double t) {
  double along = 0;
  for (int end = 0; end < ends_of(element); ++end) {
    const Eigen::Index n = normal_row(end);
    const double gap = trial.gap(n) + t * trial.direction(n);
    const double slide = trial.gap(n + 1) + t * trial.direction(n + 1);
    const double capacity = trial.capacity[static_cast<std::size_t>(end)];
    along += trial.direction(n) * press(trial.rule, row_of(element, trial, n), gap).force;
    along += trial.direction(n + 1) * shear(row_of(element, trial, n + 1), slide, capacity).force;
  }
  return along;
}

double update_capacity(const InterfaceElement& element, const EndStrength& strength, InterfaceTrial& trial) {
  const Vec4 before = trial.force;
  set_capacity(element, strength, trial);
  respond(element, trial);
  return (trial.force - before).cwiseAbs().maxCoeff();
}

bool break_ends(const EndStrength& strength, InterfaceTrial& trial) {
  if (trial.rule.sticks) return false;
  bool broke = false;
  for (int end = 0; end < 2; ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    if (trial.broken[e] || !exceeds(strength, trial.force(n), trial.force(n + 1))) continue;
    trial.broken[e] = broke = true;
  }
  return broke;
}

Vec4 dashpot_force(const InterfaceElement& element, const InterfaceTrial& trial) {
  Vec4 force = Vec4::Zero();
  if (trial.rule.dashpot_rate == 0 || element.dashpot.isZero(0)) return force;
  for (int end = 0; end < ends_of(element); ++end) {
    const Eigen::Index n = normal_row(end);
    const Row normal = row_of(element, trial, n);
    const Row tangent = row_of(element, trial, n + 1);
    if (!normal.broken) continue;
    force(n) = trial.force(n) - spring(trial.rule, normal.stiffness, normal.start, trial.gap(n)).force;
    if (trial.active(n + 1) != 0) force(n + 1) = tangent.dashpot * (trial.gap(n + 1) - tangent.start);
  }
  return force;
}

bool release_shear(const InterfaceElement& element, const EndStrength& strength, InterfaceState& state) {
  if (has_stress_rows(element)) return false;
  bool released = false;
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    const double capacity = strength.friction * std::max(0.0, -state.force(n));
    if (!state.broken[e] || std::abs(state.force(n + 1)) <= capacity) continue;
    state.force(n + 1) = std::copysign(capacity, state.force(n + 1));
    const double left = elastic_gap(state.force(n + 1), element.stiffness(n + 1), state.gap(n + 1));
    state.slip[e] += state.gap(n + 1) - left;
    state.gap(n + 1) = left;
    state.status[e] = ContactStatus::sliding;
    released = true;
  }
  return released;
}

InterfaceState finish_trial(const InterfaceElement& element, const InterfaceState& start, const InterfaceTrial& trial) {
  InterfaceState state = start;
  state.gap = trial.gap;
  state.force = trial.force;
  state.broken = trial.broken;
  if (has_stress_rows(element)) return state;
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    if (trial.broken[e]) state.force(n) = element.stiffness(n) * pressed(trial.gap(n));
    if (trial.broken[e] && trial.gap(n) >= 0) {
      state.status[e] = ContactStatus::open;
      state.force.segment<2>(n).setZero();
      state.gap(n + 1) = 0;  // a joint that closes again starts without shear
      continue;
    }
    state.status[e] = trial.active(n + 1) != 0 ? ContactStatus::locked : ContactStatus::sliding;
    if (state.status[e] == ContactStatus::locked) {
      state.force(n + 1) = element.stiffness(n + 1) * trial.gap(n + 1);
      continue;
    }
    state.gap(n + 1) = elastic_gap(trial.force(n + 1), element.stiffness(n + 1), trial.gap(n + 1));
    state.slip[e] += trial.gap(n + 1) - state.gap(n + 1);
  }
  return state;
}

std::array<bool, 2> ends_beyond_strength(const EndStrength& strength, const Vec4& force) {
  return {exceeds(strength, (force(0) - force(2)) / 2, force(1) / 2),
          exceeds(strength, (force(0) + force(2)) / 2, force(1) / 2)};
}

}  // namespace dda
