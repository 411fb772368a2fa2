#include "dda/contact/open_close.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dda {
namespace {

constexpr double at_capacity = 1e-12;

struct Answer {
  double force;
  bool active;
};

Answer press(double stiffness, double gap, bool broken) {
  if (broken && gap >= 0) return {0, false};
  return {stiffness * gap, true};
}

Answer shear(double stiffness, double gap, bool broken, double capacity) {
  const double stuck = stiffness * gap;
  // A joint that slid in the last step starts this one right at its capacity: it slides on unless it turns back.
  if (broken && std::abs(stuck) >= (1 - at_capacity) * capacity) return {std::copysign(capacity, stuck), false};
  return {stuck, true};
}

int ends_of(const InterfaceElement& element) { return element.length > 0 ? 2 : 1; }

Eigen::Index normal_row(int end) { return 2 * end; }

// Capacity of an end: friction times the force that presses it.
void set_capacity(const InterfaceElement& element, const EndStrength& strength, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end)
    trial.capacity[static_cast<std::size_t>(end)] = strength.friction * std::max(0.0, -trial.force(normal_row(end)));
}

// An end that slid in the last step starts this one at its capacity, but for round-off and the gap measured anew: the
// first pass takes it to slide on.
void keep_sliding(const InterfaceElement& element, const InterfaceState& start, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index row = normal_row(end) + 1;
    if (start.status[e] != ContactStatus::sliding || trial.capacity[e] == 0) continue;
    trial.force(row) = std::copysign(trial.capacity[e], start.gap(row));
    trial.active(row) = 0;
  }
}

}  // namespace

InterfaceTrial start_trial(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& start) {
  InterfaceTrial trial;
  trial.gap = start.gap;
  trial.broken = start.broken;
  trial.force = start.force;
  if (has_stress_rows(element)) return trial;
  set_capacity(element, strength, trial);  // by the forces of the start
  respond(element, trial);
  keep_sliding(element, start, trial);
  return trial;
}

void respond(const InterfaceElement& element, InterfaceTrial& trial) {
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    const Answer normal = press(element.stiffness(n), trial.gap(n), trial.broken[e]);
    const Answer tangent = shear(element.stiffness(n + 1), trial.gap(n + 1), trial.broken[e], trial.capacity[e]);
    trial.force.segment<2>(n) << normal.force, tangent.force;
    trial.active.segment<2>(n) << (normal.active ? 1 : 0), (tangent.active ? 1 : 0);
  }
}

double force_along(const InterfaceElement& element, const InterfaceTrial& trial, double t) {
  double along = 0;
  for (int end = 0; end < ends_of(element); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    const double gap = trial.gap(n) + t * trial.direction(n);
    const double slide = trial.gap(n + 1) + t * trial.direction(n + 1);
    along += trial.direction(n) * press(element.stiffness(n), gap, trial.broken[e]).force;
    along += trial.direction(n + 1) * shear(element.stiffness(n + 1), slide, trial.broken[e], trial.capacity[e]).force;
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
  bool broke = false;
  for (int end = 0; end < 2; ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = normal_row(end);
    if (trial.broken[e] || !exceeds(strength, trial.force(n), trial.force(n + 1))) continue;
    trial.broken[e] = broke = true;
  }
  return broke;
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
    if (trial.active(n) == 0) {
      state.status[e] = ContactStatus::open;
      state.force.segment<2>(n).setZero();
      state.gap(n + 1) = 0;  // a joint that closes again starts without shear
      continue;
    }
    state.status[e] = trial.active(n + 1) != 0 ? ContactStatus::locked : ContactStatus::sliding;
    if (state.status[e] == ContactStatus::locked) continue;
    state.gap(n + 1) = elastic_gap(trial.force(n + 1), element.stiffness(n + 1), trial.gap(n + 1));
    state.slip[e] += trial.gap(n + 1) - state.gap(n + 1);
  }
  return state;
}

bool beyond_strength(const EndStrength& strength, const Vec4& force) {
  return exceeds(strength, (force(0) - force(2)) / 2, force(1) / 2) ||
         exceeds(strength, (force(0) + force(2)) / 2, force(1) / 2);
}

}  // namespace dda
