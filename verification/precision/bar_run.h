// The thesis' bar (100 m, stress at 50 m) under one sine cycle, bare or in an envelope.
#pragma once

#include "engine/model/model.h"
#include "verification/precision/scheme_settings.h"

namespace verify {

[[nodiscard]] PrecisionResult run_bar(const PrecisionJob& job);

// Finished; its measurement is the normal traction at 50 m. 50 m must be whole blocks.
[[nodiscard]] dda::Model bar_model(const PrecisionJob& job);

// Force on the left end (over its amplitude) at time t.
[[nodiscard]] double bar_pulse(Problem problem, double t);

// Half-way between the moment the pulse has passed 50 m and that its reflection is back there, s.
[[nodiscard]] double bar_window();

// Errors of a history of stress at 50 m (Pa, at t = i dt) against the wave equation's: relative L2 norm of the
// difference; and the larger of the errors of velocity (by cross-correlation) and amplitude (the factor of the delayed
// wave that fits best), NaN with fewer than 8 samples in a period or where the wave is 0.45 of a period off its time.
[[nodiscard]] HistoryErrors bar_errors(Problem problem, const std::vector<double>& history, double dt);

}  // namespace verify
