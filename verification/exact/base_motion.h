// Motion of a base whose acceleration is given by samples with straight lines between them, and of an oscillator on it.
#pragma once

#include <vector>

namespace exact {

struct Accelerogram {
  std::vector<double> times;   // s, increasing; the first is the start, at rest
  std::vector<double> values;  // m/s2
};

struct BaseMotion {
  double displacement = 0;  // m
  double velocity = 0;      // m/s
};

// At `time` (s): the polynomials of each interval one after the other.
[[nodiscard]] BaseMotion base_motion(const Accelerogram& record, double time);

// Displacement (m) and velocity relative to the base of an undamped oscillator, u'' + omega^2 u = -a(t), at rest at the
// start. Exact for straight lines: in each interval the particular solution -(a + s t)/omega^2 and a free oscillation
// (Duhamel's integral; Nigam & Jennings 1969).
[[nodiscard]] BaseMotion oscillator_on_base(const Accelerogram& record, double omega, double time);

}  // namespace exact
