// The bodies that move as one, and the faces around each.
#pragma once

#include <vector>

#include "engine/keyblocks/joint_face.h"
#include "engine/model/model.h"

namespace dda {

// A block, or several that bonded joints make one.
struct RockBody {
  std::vector<int> blocks;  // in ascending order
  // Held as a whole, on a support or beside a boundary that absorbs waves: what block theory calls infinite.
  bool surroundings = false;
  double area = 0;               // m2
  double mass = 0;               // kg per m of thickness
  Vec2 centroid = Vec2::Zero();  // of the mass
  std::vector<JointFace> joints;
  std::vector<FreeFace> free_faces;
};

// The model must be finished. Blocks that `is_void` marks are taken out: they are in no body, and leave free faces.
std::vector<RockBody> rock_bodies(const Model& model, const std::vector<bool>& is_void);

}  // namespace dda
