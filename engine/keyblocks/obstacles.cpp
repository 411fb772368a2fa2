#include "engine/keyblocks/obstacles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/geometry/segment.h"
#include "engine/keyblocks/first_motion.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<const Ring*> outlines_of(const Model& model) {
  std::vector<const Ring*> outlines;
  for (const Block& block : model.blocks) outlines.push_back(&block.shape.outer);
  return outlines;
}

template <typename Visit>
void visit_rings(const Polygon& shape, const Visit& visit) {
  visit(shape.outer);
  for (const Ring& hole : shape.holes) visit(hole);
}

// A body on its way.
class Motion {
 public:
  Motion(const Model& model, const RockBody& body, const Vec2& direction)
      : model_(model),
        body_(body),
        tolerance_(10 * model.length_tolerance),
        step_(std::max(1e-3 * std::sqrt(body.area), 100 * tolerance_) * direction) {
    for (const JointFace& face : body.joints)
      if (std::abs(face.outward.dot(direction)) <= along_the_way) sliding_.push_back(face);
    for (const int block : body.blocks) visit_rings(shape(block), [this](const Ring& ring) { note(ring); });
  }

  // The box around all places on the way.
  [[nodiscard]] const Box& box() const { return box_; }

  // A corner of the body that touches or enters the block, else a corner of the block that enters the body.
  [[nodiscard]] std::optional<Vec2> meets(int block) const {
    const auto own = std::ranges::find_if(corners_, [&](const Vec2& corner) { return reaches(corner + step_, block); });
    if (own != corners_.end()) return *own;
    std::optional<Vec2> found;
    visit_rings(shape(block), [&](const Ring& ring) {
      const auto corner = std::ranges::find_if(ring, [&](const Vec2& each) { return is_in_body(each - step_); });
      if (corner != ring.end()) found = *corner;
    });
    return found;
  }

 private:
  [[nodiscard]] const Polygon& shape(int block) const { return model_.blocks[at(block)].shape; }

  void note(const Ring& ring) {
    corners_.insert(corners_.end(), ring.begin(), ring.end());
    for (const Vec2& corner : ring) box_ = expanded(expanded(box_, corner), Vec2(corner + step_));
  }

  [[nodiscard]] bool reaches(const Vec2& place, int block) const {
    if (locate(shape(block), place, tolerance_) == Location::inside) return true;
    bool touches = false;
    visit_rings(shape(block), [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size() && !touches; ++i) {
        const Segment edge{ring[i], ring[(i + 1) % ring.size()]};
        touches = distance(edge, place) <= tolerance_ && !is_slid_along(edge, block);
      }
    });
    return touches;
  }

  [[nodiscard]] bool is_slid_along(const Segment& edge, int block) const {
    return std::ranges::any_of(sliding_, [&](const JointFace& face) {
      return face.neighbour == block && collinear_overlap(edge, {face.from, face.to}, point_tolerance(model_));
    });
  }

  [[nodiscard]] bool is_in_body(const Vec2& place) const {
    return std::ranges::any_of(body_.blocks,
                               [&](int block) { return locate(shape(block), place, tolerance_) == Location::inside; });
  }

  const Model& model_;
  const RockBody& body_;
  double tolerance_;  // m
  Vec2 step_;         // m
  std::vector<JointFace> sliding_;
  std::vector<Vec2> corners_;
  Box box_;
};

}  // namespace

Obstacles::Obstacles(const Model& model, const std::vector<bool>& is_void)
    : model_(model), is_void_(is_void), index_(outlines_of(model)) {}

std::vector<Obstacle> Obstacles::in_way_of(const RockBody& body, const Vec2& direction) const {
  const Motion motion(model_, body, direction);
  std::vector<Obstacle> found;
  for (const int block : index_.near(expanded(motion.box(), point_tolerance(model_)))) {
    if (is_void_[at(block)] || std::ranges::binary_search(body.blocks, block)) continue;
    if (const auto place = motion.meets(block)) found.push_back({block, *place});
  }
  return found;
}

}  // namespace dda
