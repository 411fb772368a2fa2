#include "engine/model/common_centroid.h"

#include <cstddef>

namespace dda {

Vec2 common_centroid(const std::vector<int>& blocks, const Model& model) {
  double area = 0;
  Vec2 sum = Vec2::Zero();
  for (const int block : blocks) {
    const AreaMoments& moments = model.blocks[static_cast<std::size_t>(block)].moments;
    area += moments.area;
    sum += moments.area * moments.centroid;
  }
  return sum / area;
}

}  // namespace dda
