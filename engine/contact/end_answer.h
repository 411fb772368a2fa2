// What one row of an end answers to its gap in a step: its force (N per m of thickness) and the slope of that over the
// stiffness. Pressing rows know of their spring, dashpot and bond; shearing rows of their capacity and hardening as
// well. In the header, since passes over all contacts do little else.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/interface_trial.h"

namespace dda::end_answer {

inline constexpr double at_capacity = 1e-12;
inline constexpr double steepest_slip = 1 - 1e-9;  // slope of an end that slides; one that sticks has 1 or more

struct Answer {
  double force;
  double slope;  // over the stiffness
};

inline double pressed(double gap) { return std::min(0.0, gap); }

// The spring's part of the balance that makes its work the change of its energy; see interface_trial.h.
inline Answer conserving_spring(double stiffness, double start, double gap) {
  if (start < 0 && gap < 0) return {stiffness * gap, 1};
  if (start >= 0 && gap >= 0) return {0, 0};
  const double share = std::min(start, gap) / -std::abs(gap - start);  // of the way that lies in contact
  return {stiffness * gap * share, start < 0 ? share * share : share * (2 - share)};
}

inline Answer spring(const ContactRule& rule, double stiffness, double start, double gap) {
  if (rule.conserves_energy) return conserving_spring(stiffness, start, gap);
  return gap >= 0 ? Answer{0, 0} : Answer{stiffness * gap, 1};
}

struct Row {
  double stiffness;
  double dashpot;  // N/m: dashpot * rate
  double start;    // gap at the start of the step
  bool broken;
};

inline Row row_of(const InterfaceSprings& springs, const InterfaceTrial& trial, Eigen::Index row) {
  return {springs.stiffness(row), springs.dashpot(row) * trial.rule.dashpot_rate, trial.start(row),
          trial.broken[static_cast<std::size_t>(row / 2)]};
}

inline Answer press(const ContactRule& rule, const Row& row, double gap) {
  if (!row.broken) return {row.stiffness * gap, 1};
  const Answer elastic = spring(rule, row.stiffness, row.start, gap);
  if (row.dashpot == 0) return elastic;
  // Spring and dashpot together do not pull: in the balance of means, together with the force of the start.
  const double no_pull = rule.conserves_energy ? -row.stiffness * pressed(row.start) : 0;
  const double both = elastic.force + row.dashpot * (pressed(gap) - pressed(row.start));
  if (both >= no_pull) return {no_pull, 0};
  return {both, elastic.slope + (gap < 0 ? row.dashpot / row.stiffness : 0)};
}

// Shear force of an end that slides: `force` where slip begins, and `hardening` more for each metre.
struct Yield {
  double force;
  double hardening;
};

// Slip towards `side` hardens when it leads away from the start.
inline Yield yield_of(const InterfaceTrial& trial, std::size_t end, double side) {
  const double capacity = trial.capacity[end];
  const bool outwards = side * trial.slip[end] >= 0;
  if (trial.hardening[end] == 0 || capacity == 0 || !outwards) return {capacity, 0};
  const double reference = std::max(0.0, side * trial.reference[end]);
  // More would make the end slide by itself.
  const double hardening = reference > 0 ? std::min(trial.hardening[end], capacity / reference) : trial.hardening[end];
  return {capacity - hardening * reference, hardening};
}

inline double stuck_force(const Row& row, double gap) {
  return row.stiffness * gap + (row.broken ? row.dashpot * (gap - row.start) : 0);
}

inline double stuck_slope(const Row& row) {
  return 1 + (row.broken && row.dashpot > 0 ? row.dashpot / row.stiffness : 0);
}

inline Answer shear(const Row& row, double gap, const InterfaceTrial& trial, std::size_t end) {
  const double stuck = stuck_force(row, gap);
  const double slope = stuck_slope(row);
  if (!row.broken) return {stuck, slope};
  const double before = trial.before(static_cast<Eigen::Index>(2 * end + 1));
  const double both = stuck + before;
  const auto [yield, hardening] = yield_of(trial, end, std::copysign(1, both));
  // A joint that slid in the last step starts this one right at its capacity: it slides on unless it turns back.
  if (std::abs(both) < (1 - at_capacity) * yield) return {stuck, slope};
  if (hardening == 0) return {std::copysign(yield, both) - before, 0};
  const double share = hardening / (row.stiffness + row.dashpot + hardening);
  // With a dashpot the slope of an end that hardens steeply can reach that of a stuck one, by which others know it.
  return {std::copysign((1 - share) * yield + share * std::abs(both), both) - before,
          std::min(share * slope, steepest_slip)};
}

}  // namespace dda::end_answer
