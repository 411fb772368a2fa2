// What the end of a bar sends back of a pulse, from the history of one block on the pulse's way there and back.
#pragma once

#include <complex>
#include <vector>

#include "verification/exact/chain_modes.h"

namespace verify {

struct EndReflection {
  double probe = 0;   // m, from where the pulse is pushed in to the centre of the block
  double length = 0;  // m, from there to the end
  double speed = 0;   // m/s
  double pulse = 0;   // s
  double dt = 0;      // s, between samples; the first is at t = 0

  [[nodiscard]] double duration() const;  // s, until the pulse has come back past the probe
  // Complex amplitude at the angular frequency omega of what comes back over that of what arrives, both at the end:
  // led there with the speed and attenuation of the waves of the discrete bar.
  [[nodiscard]] std::complex<double> of(const std::vector<double>& history, double omega,
                                        const exact::ChainWave& wave) const;
};

}  // namespace verify
