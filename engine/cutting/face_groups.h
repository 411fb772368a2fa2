// Which faces make up a block: faces in the rock each by itself to begin with, all others together outside.
#pragma once

#include <vector>

#include "engine/cutting/arrangement.h"
#include "engine/cutting/plan_pieces.h"

namespace dda {

// What a face belongs to.
struct FacePlace {
  bool in_boundary = false;  // and in no hole
  bool left_out = false;     // in an opening that is not cut
  int opening = -1;          // the last of the plan's that holds it

  [[nodiscard]] bool in_rock() const { return in_boundary && !left_out; }
};

// By face. Crossing an edge changes the side of each closed curve that runs along it.
std::vector<FacePlace> places_of_faces(const Arrangement& arrangement, const PlanPieces& pieces, const RockPlan& plan);

class FaceGroups {
 public:
  explicit FaceGroups(const std::vector<FacePlace>& places);

  static constexpr int outside = 0;  // the group of the face without end
  [[nodiscard]] int of(int face) const;
  void merge(int into, int group);
  // Several threads may ask from now on, until groups are merged again.
  void settle();

 private:
  mutable std::vector<int> parent_;
};

// Between two groups, one of which at least is a block.
inline bool is_border(const Arrangement& arrangement, const FaceGroups& groups, int half_edge) {
  return groups.of(arrangement.face(half_edge)) != groups.of(arrangement.face(twin(half_edge)));
}

}  // namespace dda
