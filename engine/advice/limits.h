// How coarse blocks and time steps may be for a wanted error.
#pragma once

#include <functional>
#include <optional>

namespace dda {

// The larger of the errors of speed and amplitude at this dt (s) with blocks `scale` times as large; nothing where no
// wave arrives.
using ErrorOf = std::function<std::optional<double>(double dt, double scale)>;

struct CoarseBounds {
  double dt = 0;     // s, coarsest that is tried: four steps in a period
  double scale = 0;  // blocks of a quarter of a wavelength
};

struct WaveLimits {
  std::optional<double> dt;     // s, with the blocks as they are
  std::optional<double> scale;  // of the blocks, with dt as it is
  // Where neither alone is enough: blocks and a dt that are.
  std::optional<double> both_dt, both_scale;
  CoarseBounds finest, coarsest;  // that were tried; what lies beyond is not known
};

// Looks from coarse to fine down to a thousandth (2^-10), in steps of a factor 2, and then between the last two. An
// error that passes zero between two that are too large does not count: four fifths of a value must be within as well.
WaveLimits find_limits(const ErrorOf& error_of, double dt, const CoarseBounds& coarse, double wanted);

}  // namespace dda
