// Faces of two blocks that a stretch holds together though the blocks can touch elsewhere as well.
//
// A joint that is closed, or torn at an edge, stays a stretch. Blocks whose outlines point inwards, as a bench and the
// wall behind it, may meet beside it for all that, and contacts of their vertices are looked for there. Those of the
// stretch's own faces are none: it stands for them.
#pragma once

#include <utility>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"

namespace dda {

struct HeldFace {
  int block_a = 0, block_b = 0;
  Vec2 from, to;                // m, as drawn
  Vec2 centroid_a, centroid_b;  // m, as drawn: outlines go by offsets from them
  double tolerance = 0;         // m, by which a vertex may lie off the line that it is on

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, from, to, centroid_a, centroid_b, tolerance] = self;
    archive.blocks(block_a, block_b);
    archive(from, to, centroid_a, centroid_b, tolerance);
  }

  [[nodiscard]] std::pair<int, int> pair() const { return std::minmax(block_a, block_b); }
};

HeldFace held_face(const Model& model, const Interface& stretch);

class HeldFaces {
 public:
  HeldFaces() = default;
  explicit HeldFaces(std::vector<HeldFace> faces);

  [[nodiscard]] bool empty() const { return faces_.empty(); }

  // Whether a vertex at an edge is on one of the faces: both as they were drawn, wherever the blocks are now.
  [[nodiscard]] bool stand_for(const Outlines& outlines, const VertexContact& contact) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [faces] = self;
    archive(faces);
  }

 private:
  std::vector<HeldFace> faces_;  // sorted by their pairs of blocks
};

}  // namespace dda
