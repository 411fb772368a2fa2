#include "verification/harness/nearest_block.h"

#include <cstddef>
#include <limits>

namespace verify {

int nearest_block(const dda::Model& model, const dda::Vec2& place) {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double distance = (model.blocks[i].moments.centroid - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

}  // namespace verify
