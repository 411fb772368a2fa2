// The thesis' bar for a job: its blocks fit the wanted length, and its load may be another one.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "verification/sweep/parameters.h"
#include "verification/thesis/reference.h"

namespace verify {

// The measuring point is the joint nearest to 50 m, and the bar has whole blocks: at least 100 m of them for the cycle,
// 200 m for the tone, so that nothing comes back from its end while the pulse passes.
[[nodiscard]] ThesisBar bar_of(const JobParameters& parameters);

// Force on the left face at time t (s), in units of its amplitude.
[[nodiscard]] double pulse_shape(Pulse pulse, double frequency, double t);
[[nodiscard]] double pulse_duration(Pulse pulse, double frequency);  // s

// Half-way between the moment the pulse has passed the measuring point and that its reflection is back, s.
[[nodiscard]] double pulse_window(const ThesisBar& bar, Pulse pulse);

// Sampled at every step of the run, N.
[[nodiscard]] std::vector<double> sampled_force(const ThesisBar& bar, const JobParameters& parameters);

// The finished model; its measurement is the normal traction between the blocks at the measuring point.
[[nodiscard]] dda::Model model_of(const ThesisBar& bar, const JobParameters& parameters);

}  // namespace verify
