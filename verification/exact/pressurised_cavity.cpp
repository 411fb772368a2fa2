#include "verification/exact/pressurised_cavity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace exact {
namespace {

// Displacements and velocities of the circles between rings of equal thickness; stresses in the middle of each ring.
class Rings {
 public:
  Rings(const Cavity& cavity, double thickness, std::size_t count)
      : cavity_(cavity),
        thickness_(thickness),
        displacement_(count + 1, 0.0),
        velocity_(count + 1, 0.0),
        force_(count + 1, 0.0),
        mass_(count + 1, 0.0) {
    for (std::size_t i = 0; i < count; ++i) {  // half of each ring's mass per radian to each of its circles
      const double half = cavity.density * thickness / 2;
      mass_[i] += half * (circle(i) + thickness / 4);
      mass_[i + 1] += half * (circle(i + 1) - thickness / 4);
    }
  }

  // Velocities, then displacements, by `interval` s.
  void advance(double wall_pressure, double interval) {
    update_forces(wall_pressure);
    for (std::size_t i = 0; i < velocity_.size(); ++i) {
      velocity_[i] += interval * force_[i] / mass_[i];
      displacement_[i] += interval * velocity_[i];
    }
  }

  [[nodiscard]] RadialStress stress_in(std::size_t ring) const {
    const double radial = (displacement_[ring + 1] - displacement_[ring]) / thickness_;
    const double hoop = (displacement_[ring] + displacement_[ring + 1]) / (2 * middle(ring));
    const double lambda = cavity_.p_modulus - 2 * cavity_.shear;
    return {cavity_.p_modulus * radial + lambda * hoop, lambda * radial + cavity_.p_modulus * hoop};
  }

  // The parabola through the middles of three rings.
  [[nodiscard]] RadialStress stress_at(double radius) const {
    const auto [ring, x] = place((radius - cavity_.radius) / thickness_ - 1, displacement_.size() - 4);
    const double s = x + 0.5;  // from the middle of `ring`
    const double weights[] = {(1 - s) * (2 - s) / 2, s * (2 - s), s * (s - 1) / 2};
    RadialStress sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const RadialStress stress = stress_in(ring + i);
      sum.radial += weights[i] * stress.radial;
      sum.hoop += weights[i] * stress.hoop;
    }
    return sum;
  }

  [[nodiscard]] double velocity_at(double radius) const {
    const auto [at, share] = place((radius - cavity_.radius) / thickness_, displacement_.size() - 2);
    return velocity_[at] + share * (velocity_[at + 1] - velocity_[at]);
  }

 private:
  [[nodiscard]] double circle(std::size_t i) const { return cavity_.radius + static_cast<double>(i) * thickness_; }
  [[nodiscard]] double middle(std::size_t ring) const { return circle(ring) + thickness_ / 2; }

  // The interval of `position` (in intervals) among 0 to last, and where in it; before the first it is negative.
  static std::pair<std::size_t, double> place(double position, std::size_t last) {
    const auto at = static_cast<std::size_t>(std::clamp(std::floor(position), 0.0, static_cast<double>(last)));
    return {at, position - static_cast<double>(at)};
  }

  // Minus the derivative of the strain energy per radian, and the pressure on the wall.
  void update_forces(double wall_pressure) {
    std::fill(force_.begin(), force_.end(), 0.0);
    force_.front() = wall_pressure * cavity_.radius;
    for (std::size_t ring = 0; ring + 1 < displacement_.size(); ++ring) {
      const RadialStress stress = stress_in(ring);
      const double across = stress.hoop * thickness_ / 2;
      const double along = stress.radial * middle(ring);
      force_[ring] += along - across;
      force_[ring + 1] -= along + across;
    }
  }

  Cavity cavity_;
  double thickness_;
  std::vector<double> displacement_, velocity_, force_, mass_;
};

void append_stress(const Rings& rings, const std::vector<double>& radii, CavityMotion& motion) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const RadialStress stress = rings.stress_at(radii[i]);
    motion.histories[i].radial_stress.push_back(stress.radial);
    motion.histories[i].hoop_stress.push_back(stress.hoop);
  }
}

// Velocities are known half a step before and after: called before and after advancing, it appends their mean.
void append_half_velocity(const Rings& rings, const std::vector<double>& radii, std::size_t step,
                          CavityMotion& motion) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    motion.histories[i].velocity.resize(step + 1, 0.0);
    motion.histories[i].velocity.back() += rings.velocity_at(radii[i]) / 2;
  }
}

}  // namespace

CavityMotion pressurised_cavity(const Cavity& cavity, const std::function<double(double)>& pressure,
                                const std::vector<double>& radii, double duration, int rings_per_radius) {
  const double furthest = *std::max_element(radii.begin(), radii.end());
  if (*std::min_element(radii.begin(), radii.end()) < cavity.radius)
    throw std::invalid_argument("pressurised_cavity: a radius inside the cavity");
  const double speed = std::sqrt(cavity.p_modulus / cavity.density);
  const double thickness = cavity.radius / rings_per_radius;
  const double end = furthest + speed * duration / 2 - (furthest - cavity.radius) / 2;  // there and back to `furthest`
  const auto count = static_cast<std::size_t>((std::max(end, furthest) - cavity.radius) / thickness) + 4;
  CavityMotion motion{0.95 * thickness / speed, std::vector<RadialHistory>(radii.size())};
  Rings rings(cavity, thickness, count);
  const auto steps = static_cast<std::size_t>(std::ceil(duration / motion.interval));
  for (std::size_t step = 0; step <= steps; ++step) {
    const double p = pressure(static_cast<double>(step) * motion.interval);
    append_stress(rings, radii, motion);
    append_half_velocity(rings, radii, step, motion);
    rings.advance(p, motion.interval);
    append_half_velocity(rings, radii, step, motion);
  }
  return motion;
}

RadialStress lame_ring(double inner_radius, double outer_radius, double inner_pressure, double outer_pressure,
                       double radius) {
  const double share = std::pow(inner_radius / outer_radius, 2);
  const double mean = (inner_pressure * share - outer_pressure) / (1 - share);
  const double swing = (inner_pressure - outer_pressure) / (1 - share) * std::pow(inner_radius / radius, 2);
  return {mean - swing, mean + swing};
}

double octagon_source_radius(double equal_area) {
  constexpr double n = 8;
  const double pi = std::numbers::pi;
  const double edge = equal_area * std::sqrt(pi / (2 * (1 + std::numbers::sqrt2)));
  const double conformal =
      edge * std::tgamma(1 / n) / (std::pow(2, 1 + 2 / n) * std::sqrt(pi) * std::tgamma(0.5 + 1 / n));
  const double m = 2 / (n * (n - 1));
  return conformal * std::sqrt(1 + (n - 1) * m * m);
}

}  // namespace exact
