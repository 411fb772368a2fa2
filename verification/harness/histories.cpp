#include "verification/harness/histories.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace verify {

void keep_largest(double& largest, double error) {
  if (!std::isnan(largest) && !(std::abs(error) <= largest)) largest = std::abs(error);
}

double largest_difference(const std::vector<double>& history, const std::vector<double>& exact) {
  if (history.size() != exact.size()) throw std::invalid_argument("histories of different lengths");
  double difference = 0;
  double peak = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    keep_largest(difference, history[i] - exact[i]);
    keep_largest(peak, exact[i]);
  }
  return difference / peak;
}

}  // namespace verify
