// Numbers by lot, for tests: the same for the same seed.
#pragma once

#include <cmath>
#include <random>

namespace dda {

class Lot {
 public:
  explicit Lot(int seed) : random_(static_cast<std::mt19937::result_type>(seed)) {}

  double between(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
  // A power of ten with an exponent between the two.
  double power(double least, double most) { return std::pow(10, between(least, most)); }
  int one_of(int from, int to) { return std::uniform_int_distribution(from, to)(random_); }
  bool chance(double of_one) { return between(0, 1) < of_one; }
  bool is_one_in(int n) { return one_of(1, n) == 1; }

 private:
  std::mt19937 random_;
};

}  // namespace dda
