// Collisions of two rigid bodies in a line: what is left of their velocities.
#pragma once

#include <cmath>

namespace exact {

// (m1 v1 + m2 v2)/(m1 + m2): bodies that go on together.
[[nodiscard]] inline double common_velocity(double m1, double v1, double m2, double v2) {
  return (m1 * v1 + m2 * v2) / (m1 + m2);
}

[[nodiscard]] inline double reduced_mass(double m1, double m2) { return m1 * m2 / (m1 + m2); }

// Velocity of separation over velocity of approach of bodies with a spring (N/m) and a dashpot (N s/m) beside it
// between them, which do not pull: contact ends when the force of both is zero, while the spring is still compressed.
// With beta = dashpot/(2 m), omega0^2 = spring/m and m the reduced mass, x'' = 0 at t = atan2(2 beta omega, beta^2 -
// omega^2)/omega and e = exp(-beta t) (Schwager & Poschel 2007, Granular Matter 9, 465-469; beyond critical damping
// omega is imaginary).
[[nodiscard]] inline double dashpot_restitution(double spring, double dashpot, double reduced_mass) {
  const double beta = dashpot / (2 * reduced_mass);
  const double difference = spring / reduced_mass - beta * beta;
  const double omega = std::sqrt(std::abs(difference));
  if (omega == 0) return std::exp(-2.0);
  const double end = difference > 0 ? std::atan2(2 * beta * omega, beta * beta - omega * omega) / omega
                                    : std::log((beta + omega) / (beta - omega)) / omega;
  return std::exp(-beta * end);
}

}  // namespace exact
