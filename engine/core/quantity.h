// Quantities with units as scenes write them: "50 GPa", "1e-5 s", "35 deg". Everything inside the engine is SI.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dda {

// A block has unit thickness out of the plane, so "force" is newton per metre of thickness, and so on.
enum class Dimension {
  dimensionless,
  length,
  time,
  angle,  // rad inside
  mass,
  mass_density,
  stress,  // also pressure and moduli
  force,
  force_per_length,    // edge loads, spring stiffness
  stiffness_per_area,  // joint stiffness: stress per length of opening
  frequency,           // cycles per second
  rate,                // 1/s: damping, decay
  velocity,
  angular_velocity,
  acceleration,
  impedance,  // stress per velocity: density * wave speed
};
inline constexpr int dimension_count = static_cast<int>(Dimension::impedance) + 1;

// One accepted unit: SI value = number * numerator / denominator. Both are exact doubles (but for pi), so that "34 ms"
// gives the same double as 0.034 s.
struct Unit {
  std::string_view symbol;
  double numerator;
  double denominator;
};

// The units accepted for `dimension`; the first is the SI unit with factor 1.
std::span<const Unit> units(Dimension dimension);

// The SI unit, e.g. "kg/m3"; empty for dimensionless.
std::string_view si_unit(Dimension dimension);

// The dimension in words, e.g. "mass density".
std::string_view to_string(Dimension dimension);

// What parse_quantity accepts, in words: "a number with a unit of stress (Pa, kPa, MPa, GPa)".
std::string expected_quantity(Dimension dimension);

// Reads `text`, a decimal number and a unit of `dimension` with or without a space between, and returns it in SI.
// Exponents may be written m3, m^3 or m³; a dimensionless number has no unit or "%". Independent of the locale.
// Throws InputError (without a file) naming `field` and listing the units when the number or unit is missing, unknown,
// of another dimension, followed by anything else, or not finite.
double parse_quantity(std::string_view text, Dimension dimension, std::string_view field = "quantity");

}  // namespace dda
