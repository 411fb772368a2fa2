// Numbers by lot for populations of scenes.
#pragma once

#include <random>

namespace dda {

using Random = std::mt19937;

inline double between(double least, double most, Random& random) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

}  // namespace dda
