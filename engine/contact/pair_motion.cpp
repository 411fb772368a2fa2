#include "engine/contact/pair_motion.h"

#include <algorithm>
#include <array>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

std::array<Vec2, 4> corners(const Box& box) {
  return {box.lower, Vec2(box.upper.x(), box.lower.y()), box.upper, Vec2(box.lower.x(), box.upper.y())};
}

}  // namespace

Vec2 displacement_of(const Vec6& increments, const Vec2& arm) {
  const double half_shear = increments(5) / 2;
  return {increments(0) + increments(3) * arm.x() + (half_shear - increments(2)) * arm.y(),
          increments(1) + (half_shear + increments(2)) * arm.x() + increments(4) * arm.y()};
}

Vec2 place_after(const MovingBox& block, const Vec2& place) {
  return block.centroid + block.increments.head<2>() +
         deformation_increment(block.increments) * (place - block.centroid);
}

double largest_displacement(const MovingBox& block) {
  double largest = 0;
  for (const Vec2& corner : corners(block.box)) largest = std::max(largest, displacement_at(block, corner).norm());
  return largest;
}

double relative_displacement(const MovingBox& a, const MovingBox& b, double distance) {
  const Box near_a = expanded(a.box, distance);
  const Box near_b = expanded(b.box, distance);
  const Box common{near_a.lower.cwiseMax(near_b.lower), near_a.upper.cwiseMin(near_b.upper)};
  if (is_empty(common)) return 0;
  double largest = 0;
  for (const Vec2& corner : corners(common)) {
    largest = std::max(largest, (displacement_at(a, corner) - displacement_at(b, corner)).norm());
  }
  return largest;
}

}  // namespace dda
