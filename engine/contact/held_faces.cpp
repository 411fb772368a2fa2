#include "engine/contact/held_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/geometry/segment.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

const Vec2& centroid_of(const Model& model, int block) {
  return model.blocks[static_cast<std::size_t>(block)].moments.centroid;
}

// Points as drawn, seen from the start of a face.
class FaceLine {
 public:
  explicit FaceLine(const HeldFace& face)
      : face_(face), length_((face.to - face.from).norm()), along_((face.to - face.from) / length_) {}

  [[nodiscard]] bool is_beside(const Vec2& point) const {
    return std::abs(cross(along_, point - face_.from)) <= face_.tolerance;
  }
  [[nodiscard]] bool has(const Vec2& point) const {
    const double place = along_.dot(point - face_.from);
    return is_beside(point) && place >= -face_.tolerance && place <= length_ + face_.tolerance;
  }

 private:
  const HeldFace& face_;
  double length_;
  Vec2 along_;
};

bool stands_for(const HeldFace& face, const Outlines& outlines, const VertexContact& contact) {
  const auto drawn = [&](int block, int vertex) -> Vec2 {
    return (block == face.block_a ? face.centroid_a : face.centroid_b) +
           outlines.reference[static_cast<std::size_t>(vertex)];
  };
  const FaceLine line(face);
  const int end = outlines.next[static_cast<std::size_t>(contact.edge)];
  return line.has(drawn(contact.vertex_block, contact.vertex)) &&
         line.is_beside(drawn(contact.edge_block, contact.edge)) && line.is_beside(drawn(contact.edge_block, end));
}

}  // namespace

HeldFace held_face(const Model& model, const Interface& stretch) {
  return {stretch.block_a,
          stretch.block_b,
          stretch.from,
          stretch.to,
          centroid_of(model, stretch.block_a),
          centroid_of(model, stretch.block_b),
          point_tolerance(model)};
}

HeldFaces::HeldFaces(std::vector<HeldFace> faces) : faces_(std::move(faces)) {
  std::ranges::stable_sort(faces_, {}, &HeldFace::pair);
}

bool HeldFaces::stand_for(const Outlines& outlines, const VertexContact& contact) const {
  const std::pair<int, int> pair = blocks_of(contact);
  auto face = std::ranges::lower_bound(faces_, pair, {}, &HeldFace::pair);
  for (; face != faces_.end() && face->pair() == pair; ++face)
    if (stands_for(*face, outlines, contact)) return true;
  return false;
}

}  // namespace dda
