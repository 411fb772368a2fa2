// Vectors of six numbers a block, worked on by all threads: what is done to each number, and sums over all.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "engine/core/parallel.h"

namespace dda {

// What is worth telling another thread (engine/linear/README.md): products with 6x6 blocks and the like for so many
// blocks, and for more of them what only reads and writes vectors.
inline constexpr std::size_t blocks_worth_sharing = 256;
inline constexpr std::size_t stretch_worth_sharing = 1024;

// Sums of fewer than twice as many are those of a plain loop: a tenth of a step's time at most, and its bits are those
// that results have always had.
inline constexpr std::size_t blocks_of_plain_sum = 2048;

// Some consecutive blocks of vectors.
class VectorStretch {
 public:
  VectorStretch(std::size_t first, std::size_t last)
      : first_(static_cast<Eigen::Index>(6 * first)), length_(static_cast<Eigen::Index>(6 * (last - first))) {}

  template <typename Vector>
  [[nodiscard]] auto of(Vector&& vector) const {
    return vector.segment(first_, length_);
  }

 private:
  Eigen::Index first_, length_;
};

inline std::size_t blocks_of(Eigen::Index unknowns) { return static_cast<std::size_t>(unknowns / 6); }

// body(stretch) for stretches that together are the vectors of so many unknowns.
template <typename Body>
void in_stretches(Eigen::Index unknowns, const Body& body) {
  parallel_for(blocks_of(unknowns), stretch_worth_sharing,
               [&body](std::size_t first, std::size_t last) { body(VectorStretch(first, last)); });
}

// The sum of body(stretch).
template <typename Body>
double sum_of_stretches(Eigen::Index unknowns, const Body& body) {
  return parallel_sum(blocks_of(unknowns), blocks_of_plain_sum,
                      [&body](std::size_t first, std::size_t last) { return body(VectorStretch(first, last)); });
}

template <typename One, typename Other>
double dot(const One& one, const Other& other) {
  return sum_of_stretches(one.size(), [&](const VectorStretch& here) { return here.of(one).dot(here.of(other)); });
}

}  // namespace dda
