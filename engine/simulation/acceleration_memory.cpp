#include "engine/simulation/acceleration_memory.h"

#include <cstddef>

namespace dda {
namespace {

// Halves what a motion's acceleration has gained; one that has faded stays as it is.
template <int Size>
void halve_gain(const Eigen::Matrix<double, Size, 1>& weights, const Vec6& before, int first, Vec6& now) {
  const auto old = before.segment<Size>(first);
  auto own = now.segment<Size>(first);
  if (own.cwiseAbs2().dot(weights) > old.cwiseAbs2().dot(weights)) own = ((own + old) / 2).eval();
}

}  // namespace

void AccelerationMemory::halve(std::vector<Vec6>& acceleration) const {
  using One = Eigen::Matrix<double, 1, 1>;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    halve_gain<2>(Vec2(1, 1), start_[i], 0, acceleration[i]);
    halve_gain<1>(One(1), start_[i], 2, acceleration[i]);
    halve_gain<3>(Vec3(1, 1, 0.5), start_[i], 3, acceleration[i]);  // a norm of strains in any direction
  }
}

}  // namespace dda
