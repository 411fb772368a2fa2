// What an integrator's steps make of the time derivatives of a wave exp(s t).
#pragma once

#include <complex>
#include <optional>

#include "engine/model/settings.h"

namespace dda {

using Complex = std::complex<double>;

// 1/s2 that stands for s^2: with z = exp(s dt)
//   (z - 2 + 1/z)/(dt^2 (beta z + (1/2 + gamma - 2 beta) + (1/2 - gamma + beta)/z)) ((1 - am) + am/z)/((1 - af) + af/z)
// from the three equations of the integrator (settings.h), for histories that begin at zero. Damping of velocities is
// not part of it.
Complex stepped_square(const Integrator& integrator, double dt, Complex s);

// How time passes for a wave: in steps, or, without a value, as it does.
struct TimeSteps {
  std::optional<Integrator> integrator;
  double dt = 0;  // s

  [[nodiscard]] Complex square(Complex s) const { return integrator ? stepped_square(*integrator, dt, s) : s * s; }
};

}  // namespace dda
