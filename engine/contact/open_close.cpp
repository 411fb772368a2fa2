#include "dda/contact/open_close.h"

#include <cmath>
#include <cstddef>

namespace dda {
namespace {

// What one end carries at the end of the step when closed and stuck.
struct EndTrial {
  double normal_force;
  double shear_force;
};

ContactStatus broken_status(const EndTrial& trial, double friction) {
  if (trial.normal_force >= 0) return ContactStatus::open;
  return std::abs(trial.shear_force) > -friction * trial.normal_force ? ContactStatus::sliding : ContactStatus::locked;
}

void set_open(std::size_t end, double old_slip, const Vec4& gap, InterfaceState& trial) {
  const auto row = static_cast<Eigen::Index>(2 * end);
  trial.force.segment<2>(row).setZero();
  trial.gap(row) = gap(row);
  trial.gap(row + 1) = 0;  // a joint that closes again starts without shear
  trial.slip[end] = old_slip;
}

void set_closed(const InterfaceElement& element, std::size_t end, const EndTrial& closed, double shear_force,
                double old_slip, const Vec4& gap, InterfaceState& trial) {
  const auto row = static_cast<Eigen::Index>(2 * end);
  trial.force(row) = closed.normal_force;
  trial.force(row + 1) = shear_force;
  trial.gap(row) = gap(row);
  trial.gap(row + 1) = elastic_gap(shear_force, element.stiffness(row + 1), gap(row + 1));
  trial.slip[end] = old_slip + gap(row + 1) - trial.gap(row + 1);
}

bool judge_end(const InterfaceElement& element, const EndStrength& strength, std::size_t end,
               const InterfaceState& start, const Vec4& gap, double friction_tolerance, InterfaceState& trial) {
  const auto row = static_cast<Eigen::Index>(2 * end);
  const ContactStatus old_status = trial.status[end];
  const double old_shear = trial.force(row + 1);
  const EndTrial closed{element.stiffness(row) * gap(row), element.stiffness(row + 1) * gap(row + 1)};
  if (!trial.broken[end]) trial.broken[end] = exceeds(strength, closed.normal_force, closed.shear_force);
  trial.status[end] = trial.broken[end] ? broken_status(closed, strength.friction) : ContactStatus::locked;
  if (trial.status[end] == ContactStatus::open) {
    set_open(end, start.slip[end], gap, trial);
    return old_status != ContactStatus::open;
  }
  if (trial.status[end] == ContactStatus::locked) {
    set_closed(element, end, closed, closed.shear_force, start.slip[end], gap, trial);
    return old_status != ContactStatus::locked;
  }
  const double friction = std::copysign(strength.friction * closed.normal_force, closed.shear_force);
  set_closed(element, end, closed, friction, start.slip[end], gap, trial);
  return old_status != ContactStatus::sliding ||
         std::abs(friction - old_shear) > friction_tolerance * std::abs(closed.normal_force);
}

}  // namespace

Vec4 active_rows(const InterfaceElement& element, const InterfaceState& state) {
  if (has_stress_rows(element)) return Vec4::Ones();
  Vec4 active;
  for (std::size_t end = 0; end < 2; ++end) {
    const auto row = static_cast<Eigen::Index>(2 * end);
    active(row) = state.status[end] == ContactStatus::open ? 0 : 1;
    active(row + 1) = state.status[end] == ContactStatus::locked ? 1 : 0;
  }
  return active;
}

Vec4 force_without_motion(const InterfaceElement& element, const InterfaceState& start, const InterfaceState& trial) {
  if (has_stress_rows(element)) return start.force;
  Vec4 force = active_rows(element, trial).cwiseProduct(element.stiffness).cwiseProduct(start.gap);
  for (std::size_t end = 0; end < 2; ++end) {
    const auto shear_row = static_cast<Eigen::Index>(2 * end + 1);
    if (trial.status[end] == ContactStatus::sliding) force(shear_row) = trial.force(shear_row);
  }
  return force;
}

bool judge(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& start,
           const Vec4& gap_change, const Vec3& stress_a, const Vec3& stress_b, double friction_tolerance,
           InterfaceState& trial) {
  const Vec4 gap = start.gap + gap_change;
  if (has_stress_rows(element)) {
    trial.gap = gap;
    trial.force = elastic_force(element, gap, stress_a, stress_b);
    return false;
  }
  bool changed = false;
  const std::size_t ends = element.length > 0 ? 2 : 1;
  for (std::size_t end = 0; end < ends; ++end)
    changed = judge_end(element, strength, end, start, gap, friction_tolerance, trial) || changed;
  return changed;
}

bool beyond_strength(const EndStrength& strength, const InterfaceState& trial) {
  const double shear = trial.force(1) / 2;
  return exceeds(strength, (trial.force(0) - trial.force(2)) / 2, shear) ||
         exceeds(strength, (trial.force(0) + trial.force(2)) / 2, shear);
}

}  // namespace dda
