// What an integrator's steps make of the time derivatives of a wave exp(s t).
#pragma once

#include <complex>
#include <optional>

#include "engine/model/settings.h"

namespace dda {

using Complex = std::complex<double>;

// 1/s2 that stands for s^2: with z = exp(s dt)
//   (z - 2 + 1/z)/(dt^2 (beta z + (1/2 + gamma - 2 beta) + (1/2 - gamma + beta)/z)) ((1 - am) + am/z)/((1 - af) + af/z)
// from the three equations of the integrator (settings.h), for histories that begin at zero. Where velocities keep the
// share k at the end of a step, z - 2 + 1/z is (z - 1)(1 - k/z), and the second factor of the denominator
// (k (gamma + (1 - gamma)/z) + (1 - k/z)(beta z + 1/2 - beta)). Other damping is not part of it.
Complex stepped_square(const Integrator& integrator, double dt, Complex s, double kept = 1);

// How time passes for a wave: in steps, or, without a value, as it does.
struct TimeSteps {
  std::optional<Integrator> integrator;
  double dt = 0;                 // s
  MaterialDamping damping = {};  // a and b of forces -(a M + b K) v, which act as in continuous time
  double kept = 1;               // share of velocities that a step leaves

  // s^2 of the same wave without damping: (1 + b s) K + (s2 + a s) M is 1 + b s times K + (s2 + a s)/(1 + b s) M.
  [[nodiscard]] Complex square(Complex s) const {
    const Complex square = integrator ? stepped_square(*integrator, dt, s, kept) : s * s;
    return damping.acts() ? (square + damping.mass * s) / (1.0 + damping.stiffness * s) : square;
  }
  // The share of a load that elastic forces carry; damping carries the rest.
  [[nodiscard]] Complex elastic_share(Complex s) const { return 1.0 / (1.0 + damping.stiffness * s); }
};

// Share of velocities that a step of the stage leaves.
double kept_in_step(const Stage& stage);
inline bool is_damped(const Stage& stage) { return stage.material_damping.acts() || kept_in_step(stage) != 1; }

}  // namespace dda
