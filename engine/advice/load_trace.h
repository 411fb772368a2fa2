// A load history through a transfer function: weighs every frequency that the history holds.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/advice/time_steps.h"

namespace dda {

// The least even number from `least` on that has no prime factors but 2, 3 and 5. A fast Fourier transform takes n
// times the sum of the factors of n: of 16,381 samples, a prime, as long as all the rest of an advice many times over.
std::size_t transform_size(std::size_t least);

// A load history as samples at 0, interval, 2 interval, ... (s), and the frequencies it is made of. The samples are
// followed by as much silence and weighed by exp(-decay t), so that what outlasts them does not come round again.
class LoadSpectrum {
 public:
  LoadSpectrum(const std::vector<double>& samples, double interval);

  [[nodiscard]] double interval() const { return interval_; }
  [[nodiscard]] std::size_t length() const { return length_; }
  // Hz, where the spectrum is largest.
  [[nodiscard]] double main_frequency() const;

  // What the load's samples become when exp(s t) turns into transfer(s) exp(s t), s from small imaginary parts to large
  // ones. Frequencies whose share is below 3e-5 of the largest are left out.
  [[nodiscard]] std::vector<double> through(const std::function<Complex(Complex)>& transfer) const;

 private:
  std::size_t length_;
  std::size_t size_;  // of the transform
  double interval_;
  double decay_;  // 1/s
  std::vector<Complex> spectrum_;
  double largest_ = 0;
};

}  // namespace dda
