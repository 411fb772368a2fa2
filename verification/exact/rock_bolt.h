// A rock bolt and the block that it holds. Forces in N, angles in rad.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace exact {

// Elastic up to a yield force, perfectly plastic there, without force when slack (a cable).
struct RockBolt {
  double stiffness = 0;    // N/m
  double pretension = 0;   // N
  double yield_force = 0;  // N
};

// Plastic elongation (m) after elongations that never exceeded `largest`: a cable yields in tension only, so it is what
// the largest elongation leaves beyond the elastic limit.
[[nodiscard]] inline double plastic_elongation(const RockBolt& bolt, double largest) {
  return std::max(0.0, largest - (bolt.yield_force - bolt.pretension) / bolt.stiffness);
}

// Force at `elongation` after elongations up to `largest` (which is at least `elongation`).
[[nodiscard]] inline double bolt_force(const RockBolt& bolt, double elongation, double largest) {
  return std::max(0.0, bolt.pretension + bolt.stiffness * (elongation - plastic_elongation(bolt, largest)));
}

// Plastic elongation when a mass that moves away at `speed` stretches a bolt without pretension: the kinetic energy is
// N_y^2/(2 k) of elastic energy and N_y times the plastic elongation.
[[nodiscard]] inline double plastic_elongation_of_impact(const RockBolt& bolt, double mass, double speed) {
  const double elastic = bolt.yield_force * bolt.yield_force / (2 * bolt.stiffness);
  return std::max(0.0, (mass * speed * speed / 2 - elastic) / bolt.yield_force);
}

// Least bolt force that holds a block of `weight` on an incline, the bolt pulling up the slope and at `inclination`
// into it (0: along the slope). Limit equilibrium of a wedge, e.g. Hoek & Bray, Rock Slope Engineering (1981), ch. 7:
// W (sin a - cos a tan f) = T (cos b + sin b tan f).
[[nodiscard]] inline double bolt_force_on_incline(double weight, double slope, double friction_angle,
                                                  double inclination) {
  const double friction = std::tan(friction_angle);
  return weight * (std::sin(slope) - std::cos(slope) * friction) /
         (std::cos(inclination) + std::sin(inclination) * friction);
}

}  // namespace exact
