#include "engine/keyblocks/turning.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

// A force in x, y and its moment about the centroid over the body's size.
using Wrench = Eigen::Vector3d;
using Wrenches = Eigen::Matrix3Xd;

constexpr double balanced = 1e-6;  // of what acts

// Least squares of columns * x against `target` over x >= 0 (Lawson and Hanson 1974); returns what is left.
class NonNegative {
 public:
  NonNegative(const Wrenches& columns, Wrench target)
      : columns_(columns), target_(std::move(target)), x_(Eigen::VectorXd::Zero(columns.cols())) {}

  double residual() {
    const Eigen::Index most = 10 * columns_.cols() + 10;
    for (Eigen::Index i = 0; i < most && add_best_column(); ++i) step_to_feasible();
    return (target_ - columns_ * x_).norm();
  }

 private:
  bool add_best_column() {
    const Eigen::VectorXd gain = columns_.transpose() * (target_ - columns_ * x_);
    Eigen::Index best = -1;
    for (Eigen::Index j = 0; j < gain.size(); ++j) {
      const bool used = std::find(used_.begin(), used_.end(), j) != used_.end();
      if (!used && gain[j] > 1e-12 && (best < 0 || gain[j] > gain[best])) best = j;
    }
    if (best >= 0) used_.push_back(best);
    return best >= 0;
  }

  void step_to_feasible() {
    while (!used_.empty()) {
      Wrenches part(3, static_cast<Eigen::Index>(used_.size()));
      for (std::size_t k = 0; k < used_.size(); ++k) part.col(static_cast<Eigen::Index>(k)) = columns_.col(used_[k]);
      const Eigen::VectorXd wanted = part.completeOrthogonalDecomposition().solve(target_);
      double share = 1;
      for (std::size_t k = 0; k < used_.size(); ++k) {
        const double now = x_[used_[k]];
        const double then = wanted[static_cast<Eigen::Index>(k)];
        if (then <= 0) share = std::min(share, now > 0 ? now / (now - then) : 0.0);
      }
      for (std::size_t k = 0; k < used_.size(); ++k)
        x_[used_[k]] += share * (wanted[static_cast<Eigen::Index>(k)] - x_[used_[k]]);
      if (share == 1) return;
      std::erase_if(used_, [&](Eigen::Index j) {
        const bool gone = x_[j] <= 1e-15;
        if (gone) x_[j] = 0;
        return gone;
      });
    }
  }

  const Wrenches& columns_;
  Wrench target_;
  Eigen::VectorXd x_;
  std::vector<Eigen::Index> used_;
};

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
    Wrenches columns(3, static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t i = 0; i < columns_.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) = columns_[i].normalized();
    return NonNegative(columns, target / norm).residual() <= balanced;
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
