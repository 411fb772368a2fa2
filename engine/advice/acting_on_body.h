// What acts on a body as a whole: loads and weight, without what its blocks exert on each other.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

struct ActingOnBody {
  Vec2 force = Vec2::Zero();  // N per m of thickness
  double moment = 0;          // N, about the middle of the body's blocks
  // N: sum of forces times places. In balance, and where forces keep their directions, a turn of the body by t gives
  // them the moment -t times that.
  double virial = 0;
  double sizes_of_forces = 0, sizes_of_moments = 0;  // of all, without direction: what the resultant is compared with

  // To round-off of the places and forces that a scene gives.
  [[nodiscard]] bool is_in_balance() const;
  // Whether forces that keep their directions turn the body on, as those that press on it do.
  [[nodiscard]] bool turns_further() const;
};

// On each of these sets of blocks when the stage begins, or when it ends, where that is in balance.
std::vector<ActingOnBody> acting_on_bodies(const Model& model, std::size_t stage,
                                           const std::vector<std::vector<int>>& bodies);

}  // namespace dda
