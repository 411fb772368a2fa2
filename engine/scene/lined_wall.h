// The faces of a wall that is lined: around an opening as it is in a stage, or along a line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

struct LinedWall {
  std::vector<Stretch> faces;  // one behind the other, with the material on the left
  bool closed = false;         // the last ends where the first begins
};

// Says where linings lie. Faces are those of the blocks that are there once `stage` has begun.
class Walls {
 public:
  Walls(const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings, const Model& model)
      : groups_(groups), openings_(openings), model_(model) {}

  // By exactly one of the lining's opening, cavity and along.
  [[nodiscard]] LinedWall of(const Field& lining, std::size_t stage) const;

 private:
  [[nodiscard]] Vec2 point_in_opening(const Field& name, std::size_t stage) const;

  const std::vector<std::string>& groups_;
  const std::vector<PlanOpening>& openings_;
  const Model& model_;
};

}  // namespace dda
