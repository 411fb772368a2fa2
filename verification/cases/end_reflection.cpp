#include "verification/cases/end_reflection.h"

#include <cstddef>

namespace verify {
namespace {

// Complex amplitude of a part of a history at the angular frequency omega.
std::complex<double> amplitude(const std::vector<double>& history, double dt, double omega, double from, double to) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    if (t >= from && t < to) sum += history[i] * std::polar(dt, -omega * t);
  }
  return sum;
}

}  // namespace

double EndReflection::duration() const { return (2 * length - probe) / speed + 1.6 * pulse; }

std::complex<double> EndReflection::of(const std::vector<double>& history, double omega,
                                       const exact::ChainWave& wave) const {
  const double there = probe / speed;
  const double back = (2 * length - probe) / speed;
  const double separation = (there + back + pulse) / 2;
  const std::complex<double> ratio =
      amplitude(history, dt, omega, separation, duration()) / amplitude(history, dt, omega, 0, separation);
  const double path = 2 * (length - probe);
  return ratio * std::exp(std::complex<double>(wave.attenuation * path, omega / wave.speed * path));
}

}  // namespace verify
