#include "verification/exact/bar_stress.h"

#include <cmath>
#include <numbers>

namespace exact {

double pulse_force(const SinePulse& pulse, double t) {
  const double cycles = pulse.frequency * t;
  if (cycles < 0 || cycles > 1) return 0;
  return pulse.amplitude * std::sin(2 * std::numbers::pi * cycles);
}

double exact_bar_stress(const SinePulse& pulse, double t, double x, double wave_speed, double area) {
  return -pulse_force(pulse, t - x / wave_speed) / area;
}

}  // namespace exact
