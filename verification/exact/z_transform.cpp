#include "verification/exact/z_transform.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace exact {
namespace {

Eigen::FFT<Real> half_spectrum_fft() {
  return Eigen::FFT<Real>(Eigen::FFT<Real>::impl_type(), Eigen::FFT<Real>::HalfSpectrum);
}

}  // namespace

ZCircle::ZCircle(std::size_t length)
    : length_(length), size_(std::bit_ceil(4 * length + 4)), log_radius_(std::log(1e14L) / static_cast<Real>(size_)) {}

Complex ZCircle::point(std::size_t i) const {
  const Real angle = 2 * std::numbers::pi_v<Real> * static_cast<Real>(i) / static_cast<Real>(size_);
  return std::polar(std::exp(log_radius_), angle);
}

std::vector<Complex> ZCircle::forward(const std::vector<double>& history) const {
  std::vector<Real> scaled(size_, 0);
  for (std::size_t n = 0; n < history.size(); ++n) {
    scaled[n] = widen(history[n]) * std::exp(-log_radius_ * static_cast<Real>(n));
  }
  std::vector<Complex> transform;
  half_spectrum_fft().fwd(transform, scaled);
  return transform;
}

std::vector<double> ZCircle::inverse(const std::vector<Complex>& transform) const {
  std::vector<Real> scaled;
  half_spectrum_fft().inv(scaled, transform, static_cast<Eigen::Index>(size_));
  std::vector<double> history(length_);
  for (std::size_t n = 0; n < length_; ++n) {
    history[n] = static_cast<double>(scaled[n] * std::exp(log_radius_ * static_cast<Real>(n)));
  }
  return history;
}

}  // namespace exact
