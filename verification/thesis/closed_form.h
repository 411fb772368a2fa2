// The closed form of the discrete problem that the engine solves on a bar: verification/exact fed with the model's
// data.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "verification/exact/block_chain.h"
#include "verification/exact/time_scheme.h"
#include "verification/thesis/reference.h"

namespace verify {

[[nodiscard]] exact::TimeScheme time_scheme_of(const dda::Integrator& integrator);

// The chain of a model made by bar_scene(); interface stiffnesses are the engine's.
[[nodiscard]] exact::BlockChain chain_of(const dda::Model& model);

// The exact history of the model's one measurement, sampled as the engine's (see RecordedRun).
[[nodiscard]] std::vector<double> closed_form_history(const dda::Model& model, const ThesisBar& bar);

// Phase speed (m/s) of a harmonic wave of angular frequency omega (1/s) along the model's chain under its integrator.
[[nodiscard]] double phase_speed(const dda::Model& model, double omega);

}  // namespace verify
