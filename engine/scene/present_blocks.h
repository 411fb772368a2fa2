// The blocks that are there in a stage, as a model of their own, to look for faces of them.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"

namespace dda {

struct PresentBlocks {
  PresentBlocks(const Model& all, std::size_t stage) {
    const std::vector<bool> absent = all.absent_in(stage);
    model.length_tolerance = all.length_tolerance;
    for (std::size_t i = 0; i < all.blocks.size(); ++i) {
      if (!absent.empty() && absent[i]) continue;
      model.blocks.push_back(all.blocks[i]);
      index.push_back(static_cast<int>(i));
    }
  }

  // Faces of this model as those of the whole.
  [[nodiscard]] std::vector<Stretch> in_whole(std::vector<Stretch> faces) const {
    for (Stretch& face : faces) face.block = index[static_cast<std::size_t>(face.block)];
    return faces;
  }

  Model model;
  std::vector<int> index;  // of each of its blocks in the whole
};

}  // namespace dda
