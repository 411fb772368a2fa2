// A rigid mass m (kg) that falls onto a linear spring k (N/m) at speed v (m/s) under gravity g (m/s2):
// m x'' = -k x - m g while x < 0, w = sqrt(k/m), from x(0) = 0, x'(0) = -v.
#pragma once

#include <cmath>

namespace exact {

struct SpringImpact {
  double mass = 0, spring = 0, speed = 0, gravity = 0;

  [[nodiscard]] double frequency() const { return std::sqrt(spring / mass); }  // rad/s
  [[nodiscard]] double sag() const { return mass * gravity / spring; }         // m, at rest on the spring

  // x oscillates about -sag with the amplitude that speed and sag give: largest penetration, m.
  [[nodiscard]] double deepest() const { return sag() + std::hypot(sag(), speed / frequency()); }
};

}  // namespace exact
