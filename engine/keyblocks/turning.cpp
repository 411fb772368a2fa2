#include "engine/keyblocks/turning.h"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/geometry/segment.h"
#include "engine/keyblocks/non_negative.h"

namespace dda {
namespace {

// A force in x, y and its moment about the centroid over the body's size.
using Wrench = Eigen::Vector3d;

constexpr double balanced = 1e-6;  // of what acts

class Balance {
 public:
  explicit Balance(const RockBody& body) : body_(body), size_(std::sqrt(body.area)) {}

  // A force at a place on the outline.
  void add(const Vec2& place, const Vec2& force) {
    columns_.emplace_back(force.x(), force.y(), cross(place - body_.centroid, force) / size_);
  }

  // Every force from inside the cone of friction on a face acts at its ends along the sides of the cone.
  void add_friction_cone(const JointFace& face) {
    const Vec2 along(-face.outward.y(), face.outward.x());
    for (const Vec2& end : {face.from, face.to}) {
      for (const double sign : {1.0, -1.0}) add(end, -face.outward + sign * face.tan_friction * along);
    }
  }

  // Whether the forces added, each taken as often as one likes, can balance this.
  [[nodiscard]] bool carries(const Vec2& force, double moment) const {
    Wrench target(-force.x(), -force.y(), -moment / size_);
    const double norm = target.norm();
    if (norm == 0) return true;
    Eigen::MatrixXd columns(3, static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t i = 0; i < columns_.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) = columns_[i].normalized();
    return least_left(columns, target / norm) <= balanced;
  }

 private:
  const RockBody& body_;
  double size_;
  std::vector<Wrench> columns_;
};

const JointFace& face_at(const RockBody& body, int index) { return body.joints[static_cast<std::size_t>(index)]; }

// A body that slides ever faster has all of its friction on the faces, and what is left of the force accelerates it
// through the centroid. The friction is that of all faces together, as in its factor of safety.
bool slides_without_turning(const RockBody& body, const Resultant& acting, const FirstMotion& motion) {
  const Vec2 normal = face_at(body, motion.pressed.front()).outward;
  const double pressing = normal.dot(acting.force);
  const Vec2 reaction = -pressing * normal - motion.resistance * motion.direction;
  Balance balance(body);
  for (const int index : motion.pressed) {
    for (const Vec2& end : {face_at(body, index).from, face_at(body, index).to}) balance.add(end, reaction);
  }
  return balance.carries(-reaction, acting.moment);
}

}  // namespace

bool turns(const RockBody& body, const Resultant& acting, const FirstMotion& motion) {
  if (motion.mode == Mode::falls) return false;
  if (motion.mode == Mode::slides && motion.factor_of_safety < 1) return !slides_without_turning(body, acting, motion);
  Balance balance(body);
  if (motion.mode == Mode::slides) {
    for (const int index : motion.pressed) balance.add_friction_cone(face_at(body, index));
  } else {
    for (const JointFace& face : body.joints) balance.add_friction_cone(face);
  }
  return !balance.carries(acting.force, acting.moment);
}

}  // namespace dda
