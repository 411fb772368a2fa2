// The size of what is out of balance on a block.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/core/parallel.h"
#include "engine/core/types.h"
#include "engine/linear/block_vectors.h"

namespace dda {

// What is out of balance on a block by its `own` entries of a force (N per m of thickness): the largest of its force,
// its moment and its stresses, the last two as forces at the arm of the block's size, the root of its `area` (m2).
// Force and stresses count by their lengths as vector and tensor, so that nobody's axes decide.
inline double largest_entry(const Vec6& own, double area) {
  const double stresses = own(3) * own(3) + own(4) * own(4) + 2 * own(5) * own(5);
  return std::sqrt(std::max(own.head<2>().squaredNorm(), std::max(own(2) * own(2), stresses) / area));
}

inline double largest_entry(const Eigen::VectorXd& force, std::size_t block, double area) {
  return largest_entry(force.segment<6>(static_cast<Eigen::Index>(6 * block)), area);
}

inline double larger(double one, double other) { return std::max(one, other); }

// The largest of all blocks.
inline double largest_of_blocks(const Eigen::VectorXd& force, std::span<const double> areas) {
  return parallel_reduce(areas.size(), blocks_of_plain_sum, larger, [&](std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t i = first; i < last; ++i) largest = larger(largest, largest_entry(force, i, areas[i]));
    return largest;
  });
}

}  // namespace dda
