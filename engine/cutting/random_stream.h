// Random numbers that are the same everywhere: the bits come from a generator that the C++ standard fixes, and the
// transforms are our own, as those of the standard library differ from one to the next.
#pragma once

#include <cstdint>
#include <random>

namespace dda {

enum class Spread {
  none,         // always the mean
  normal,       // `deviation` is the standard deviation
  uniform,      // mean - deviation to mean + deviation
  exponential,  // of this mean; `deviation` does not count
  lognormal,    // `deviation` is the standard deviation of the quantity itself
  fisher,       // von Mises, the distribution of Fisher on a circle: for angles; `concentration` is its kappa
};

struct RandomQuantity {
  double mean = 0;
  double deviation = 0;
  double concentration = 0;
  Spread spread = Spread::none;
};

class RandomStream {
 public:
  // Streams of one seed are independent of each other.
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  double uniform();  // in [0, 1)
  double normal();   // mean 0, deviation 1
  double sample(const RandomQuantity& quantity);
  // Drawn anew until it is above 0, which the mean must be.
  double positive_sample(const RandomQuantity& quantity);

 private:
  double fisher(double concentration);

  std::mt19937_64 bits_;
};

}  // namespace dda
