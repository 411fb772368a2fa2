// Why the thesis' tables look as they do: derived, and measured in this run.
#pragma once

#include <string_view>

#include "verification/study/document.h"
#include "verification/thesis/calibration.h"

namespace verify {

// How far a scheme's phase speed at the load's frequency is off sqrt(E/rho), %: from the closed form.
[[nodiscard]] double phase_speed_error_pct(std::string_view scheme, double dt, double length, const ThesisBar& bar);

[[nodiscard]] Section findings(const Calibration& calibration);

}  // namespace verify
