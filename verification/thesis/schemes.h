// The numerical schemes that the calibration compares. Each is one setting for all time steps and block lengths.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/model/model.h"
#include "verification/thesis/reference.h"

namespace verify {

// What "amplitude" is taken from.
enum class AmplitudeReading {
  half_range,  // (largest - smallest)/2: the reading that reproduces Table 3.2
  first_peak,  // the first compressive peak: what a wave brings before anything reflected or trailing adds to it
};

struct SchemeSettings {
  std::string name;         // as in calibration.json
  std::string title;        // for people
  std::string description;  // one sentence
  dda::JointMaterial joint;
  dda::Stage stage;  // all but dt and duration
  // stress_xx: of the block to the right of the measuring point; traction_normal: at the point, between its two blocks.
  dda::Quantity quantity = dda::Quantity::traction_normal;
  AmplitudeReading reading = AmplitudeReading::first_peak;
};

// "thesis", "classical_trapezoidal", "consistent", "accurate" and "accurate_strip": the order of the report.
[[nodiscard]] std::span<const std::string_view> scheme_names();

// Throws std::invalid_argument for a name that is none of these.
[[nodiscard]] SchemeSettings scheme_settings(std::string_view name, const ThesisBar& bar = thesis_reference().bar);

}  // namespace verify
