// The size of what is out of balance on a block.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dda {

// Of the six entries of a block in `force` (N per m of thickness) the largest; moments as forces at the arm of the
// block's size, the root of its `area` (m2).
inline double largest_entry(const Eigen::VectorXd& force, std::size_t block, double area) {
  const auto own = force.segment<6>(static_cast<Eigen::Index>(6 * block));
  const double moments = own.tail<4>().cwiseAbs().maxCoeff() / std::sqrt(area);
  return std::max(own.head<2>().cwiseAbs().maxCoeff(), moments);
}

}  // namespace dda
