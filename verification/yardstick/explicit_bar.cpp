#include "verification/yardstick/explicit_bar.h"

namespace yardstick {

ExplicitBar::ExplicitBar(const Bar& bar, double dt)
    : dt_(dt), young_over_length_(bar.young / bar.element_length()), area_(bar.area) {
  const auto elements = static_cast<std::size_t>(bar.elements);
  const double mass = bar.density * bar.area * bar.element_length();
  displacement_.assign(elements + 1, 0);
  velocity_.assign(elements + 1, 0);
  stress_.assign(elements, 0);
  step_over_mass_.assign(elements + 1, dt / mass);
  step_over_mass_.front() = step_over_mass_.back() = 2 * dt / mass;
}

void ExplicitBar::step(double force) {
  const std::size_t elements = stress_.size();
  for (std::size_t e = 0; e < elements; ++e)
    stress_[e] = young_over_length_ * (displacement_[e + 1] - displacement_[e]);
  velocity_[0] += step_over_mass_[0] * (force + area_ * stress_[0]);
  for (std::size_t i = 1; i < elements; ++i) velocity_[i] += step_over_mass_[i] * area_ * (stress_[i] - stress_[i - 1]);
  velocity_[elements] -= step_over_mass_[elements] * area_ * stress_[elements - 1];
  for (std::size_t i = 0; i <= elements; ++i) displacement_[i] += dt_ * velocity_[i];
}

double ExplicitBar::stress_at_node(int node) const {
  const auto i = static_cast<std::size_t>(node);
  return young_over_length_ * (displacement_[i + 1] - displacement_[i - 1]) / 2;
}

}  // namespace yardstick
