// What the calibration reads off a history of sigma_x. README.md says why each is read this way.
#pragma once

#include <vector>

#include "verification/thesis/reference.h"

namespace verify {

struct WavePicks {
  double half_range = 0;            // Pa, (largest - smallest)/2 up to window_end()
  double first_peak = 0;            // Pa, magnitude of the first compressive peak
  double onset_velocity = 0;        // m/s: measuring point/time of the last change of sign before that peak
  double correlation_velocity = 0;  // m/s: place/(its travel time + the lag behind the analytic stress there)
};

// End of the window that amplitudes and correlation look at, s: half-way between the moment the pulse has passed the
// measuring point (x/c + one period) and the moment its reflection from the far end comes back to it. Nothing but the
// bar and its load decide it; no pick changes visibly if it is moved by some ms.
[[nodiscard]] double window_end(const ThesisBar& bar);

// When the reflection arrives at the measuring point, s.
[[nodiscard]] double reflection_time(const ThesisBar& bar);

// Analytic sigma_x (Pa, tension positive) of the wave equation at `place` (m) before any reflection.
[[nodiscard]] double analytic_stress(const ThesisBar& bar, double time, double place);

// `history` holds sigma_x (Pa, tension positive) at t = i dt; `place` (m from the loaded end) is where it was taken.
[[nodiscard]] WavePicks pick_wave(const ThesisBar& bar, const std::vector<double>& history, double dt, double place);

}  // namespace verify
