// Whether forces within Coulomb's law give a body among others that stand still a motion: what a comparison of block
// theory with runs asks of both. Nothing here knows which way block theory would have a body go.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "engine/geometry/segment.h"
#include "engine/keyblocks/joint_face.h"
#include "engine/keyblocks/non_negative.h"

namespace dda {

// A place where a body touches another: an end of a face, as in a run.
struct TouchingEnd {
  Vec2 at;                    // m
  Vec2 outward;               // unit, out of the body
  double tan_friction = 0;    // -
  double cohesion_force = 0;  // N per m of thickness
};

// A face's pressures can be anything that its two ends can carry, and so can its friction; each has half its cohesion.
inline std::vector<TouchingEnd> ends_of(const JointFace& face) {
  const double half = face.cohesion_force / 2;
  return {{face.from, face.outward, face.tan_friction, half}, {face.to, face.outward, face.tan_friction, half}};
}

// What a body is to get from its neighbours, and what of it they cannot give.
class CoulombForces {
 public:
  // Places are counted from the centroid. `size` (m) makes forces of moments; `weight` (N per m of thickness) is what
  // all is measured by.
  CoulombForces(double size, double weight) : size_(size), weight_(weight) {}

  // Does not slide: any pressure, and shear up to N tan f + c either way.
  void sticks(const TouchingEnd& end) {
    const Vec2 along = tangent(end);
    for (const double sign : {1.0, -1.0}) add(end.at, -end.outward + sign * end.tan_friction * along);
    at_most_once(end.at, {end.cohesion_force * along, -end.cohesion_force * along}, end.cohesion_force);
  }

  // Slides the way `along`: shear is N tan f + c against it.
  void slides(const TouchingEnd& end, const Vec2& along) {
    const Vec2 against = along.dot(tangent(end)) > 0 ? Vec2(-tangent(end)) : tangent(end);
    add(end.at, -end.outward + end.tan_friction * against);
    given_ += wrench(end.at, end.cohesion_force * against) / weight_;
  }

  // Slides, and opens and closes as it goes: has its cohesion a part of the time.
  void slides_and_opens(TouchingEnd end, const Vec2& along) {
    const Vec2 against = along.dot(tangent(end)) > 0 ? Vec2(-tangent(end)) : tangent(end);
    at_most_once(end.at, {end.cohesion_force * against}, end.cohesion_force);
    end.cohesion_force = 0;
    slides(end, along);
  }

  // What is left of `force` (N per m of thickness) and `moment` (N m per m of thickness, about the centroid) when
  // these ends give as much of it as they can, of the weight.
  [[nodiscard]] double lacking(const Vec2& force, double moment) const { return lacking(force, moment, 3); }
  // The same of the force alone, where a body is thought of that cannot turn.
  [[nodiscard]] double lacking_force(const Vec2& force) const { return lacking(force, 0, 2); }

 private:
  static Vec2 tangent(const TouchingEnd& end) { return {-end.outward.y(), end.outward.x()}; }

  [[nodiscard]] Vec3 wrench(const Vec2& at, const Vec2& force) const {
    return {force.x(), force.y(), cross(at, force) / size_};
  }

  void add(const Vec2& at, const Vec2& force) { columns_.push_back({wrench(at, force).normalized(), -1, 0}); }

  // So that the shares of these forces are at most 1 together: a row more, in which they make up `scale` with what is
  // not used of it.
  void at_most_once(const Vec2& at, const std::vector<Vec2>& forces, double scale) {
    if (scale == 0) return;
    for (const Vec2& force : forces) columns_.push_back({wrench(at, force) / weight_, bounds_, scale / weight_});
    columns_.push_back({Vec3::Zero(), bounds_, scale / weight_});
    bound_scales_.push_back(scale / weight_);
    ++bounds_;
  }

  [[nodiscard]] double lacking(const Vec2& force, double moment, Eigen::Index rows) const {
    Eigen::VectorXd target(rows + bounds_);
    target.head(rows) = (Vec3(force.x(), force.y(), moment / size_) / weight_ - given_).head(rows);
    for (int i = 0; i < bounds_; ++i) target[rows + i] = bound_scales_[static_cast<std::size_t>(i)];
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(target.size(), static_cast<Eigen::Index>(columns_.size()));
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      const Column& column = columns_[static_cast<std::size_t>(j)];
      columns.col(j).head(rows) = column.wrench.head(rows);
      if (column.bound >= 0) columns(rows + column.bound, j) = column.share;
    }
    return least_left(columns, target);
  }

  struct Column {
    Vec3 wrench;
    int bound = -1;    // the row that it is bounded in; -1: none
    double share = 0;  // what it takes of that row
  };

  double size_, weight_;
  Vec3 given_ = Vec3::Zero();  // of the weight: what acts for certain
  std::vector<Column> columns_;
  std::vector<double> bound_scales_;
  int bounds_ = 0;
};

}  // namespace dda
