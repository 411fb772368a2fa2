#include "engine/advice/load_trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace dda {
namespace {

// What is left after a whole period of the transform of a motion that goes on. Its square root is what errors of the
// spectrum grow by towards the end of the window.
constexpr double come_round = 1e-4;
constexpr double negligible = 3e-5;

Eigen::FFT<double> half_spectrum() {
  return Eigen::FFT<double>(Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
}

}  // namespace

std::size_t transform_size(std::size_t least) {
  const auto is_smooth = [](std::size_t n) {
    for (const std::size_t factor : {2U, 3U, 5U})
      while (n % factor == 0) n /= factor;
    return n == 1;
  };
  std::size_t size = std::max<std::size_t>(2, least + least % 2);
  while (!is_smooth(size)) size += 2;
  return size;
}

LoadSpectrum::LoadSpectrum(const std::vector<double>& samples, double interval)
    : length_(samples.size()), size_(transform_size(2 * samples.size())), interval_(interval) {
  decay_ = -std::log(come_round) / (static_cast<double>(size_) * interval);
  std::vector<double> weighed(size_, 0);
  for (std::size_t i = 0; i < length_; ++i)
    weighed[i] = samples[i] * std::exp(-decay_ * interval * static_cast<double>(i));
  half_spectrum().fwd(spectrum_, weighed);
  for (const Complex& value : spectrum_) largest_ = std::max(largest_, std::abs(value));
}

double LoadSpectrum::main_frequency() const {
  const auto top = std::max_element(spectrum_.begin(), spectrum_.end(),
                                    [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
  return static_cast<double>(top - spectrum_.begin()) / (static_cast<double>(size_) * interval_);
}

std::vector<double> LoadSpectrum::through(const std::function<Complex(Complex)>& transfer) const {
  std::vector<Complex> changed(spectrum_.size(), 0);
  const double step = 2 * std::numbers::pi / (static_cast<double>(size_) * interval_);
  for (std::size_t i = 0; i < spectrum_.size(); ++i) {
    if (!(std::abs(spectrum_[i]) > negligible * largest_)) continue;
    changed[i] = spectrum_[i] * transfer({decay_, step * static_cast<double>(i)});
  }
  std::vector<double> trace;
  half_spectrum().inv(trace, changed, static_cast<Eigen::Index>(size_));
  trace.resize(length_);
  for (std::size_t i = 0; i < length_; ++i) trace[i] *= std::exp(decay_ * interval_ * static_cast<double>(i));
  return trace;
}

}  // namespace dda
