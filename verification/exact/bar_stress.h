// Exact one-dimensional answer to the thesis' bar: one sine cycle of force on the left end of a semi-infinite bar.
#pragma once

namespace exact {

struct SinePulse {
  double amplitude = 1e6;  // N, peak of the compressive force
  double frequency = 100;  // Hz; the pulse lasts one cycle
};

// Force (N) at time t (s): amplitude sin(2 pi f t) within [0, 1/f], else 0. Positive pushes the end in +x.
[[nodiscard]] double pulse_force(const SinePulse& pulse, double t);

// Stress sigma_x (Pa, tension positive) at distance x (m) from the end: -F(t - x/c)/area, before any reflection
// arrives.
[[nodiscard]] double exact_bar_stress(const SinePulse& pulse, double t, double x, double wave_speed, double area);

}  // namespace exact
