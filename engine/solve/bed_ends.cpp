#include "engine/solve/bed_ends.h"

#include <Eigen/LU>
#include <algorithm>

namespace dda {
namespace {

// The bed of a stretch that is all but open turns without bound: beyond this ratio of its pressures digits are lost.
constexpr double least_share = 1e-9;

// Openings of the ends by the gaps of the points.
Mat2 ends_by_points(double lever) {
  const double own = (1 + 1 / lever) / 2, other = (1 - 1 / lever) / 2;
  return (Mat2() << own, other, other, own).finished();
}

Mat2 points_by_ends(double lever) {
  const double own = (1 + lever) / 2, other = (1 - lever) / 2;
  return (Mat2() << own, other, other, own).finished();
}

}  // namespace

Vec2 openings_of_ends(double lever, const Vec2& gaps) { return ends_by_points(lever) * gaps; }

Vec2 pressures_of_ends(double lever, const Vec2& forces) { return -(points_by_ends(lever) * forces); }

Vec2 forces_of_points(double lever, const Vec2& pressures) { return -(ends_by_points(lever) * pressures); }

bool is_taken_for_a_spring(const Vec2& pressures) { return pressures.minCoeff() < least_share * pressures.sum(); }

Compression compress(const Bed& bed, const Vec2& pressures) {
  const double least = least_share * pressures.sum();
  const Vec2 forces = forces_of_points(bed.lever, pressures.cwiseMax(least));
  const Vec2 gaps = gaps_of_bed(bed, forces);
  const BedAnswer answer = press_bed(bed, gaps);
  const Mat2 slopes = (Mat2() << answer.slope(0), answer.coupling, answer.coupling, answer.slope(1)).finished();
  const Mat2 ends = ends_by_points(bed.lever);
  return {-openings_of_ends(bed.lever, gaps), ends * slopes.inverse() * ends};
}

Mat2 slopes_of_points(double lever, const Mat2& stiffness) {
  const Mat2 ends = ends_by_points(lever);
  return ends * stiffness * ends;
}

}  // namespace dda
