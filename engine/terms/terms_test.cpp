// Every term against the energy (or the Rayleigh function) it stands for, integrated or differentiated numerically.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <vector>

#include "engine/geometry/rotation.h"
#include "engine/geometry/triangulate.h"
#include "engine/model/material.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/gravity.h"
#include "engine/terms/inertia.h"
#include "engine/terms/load.h"
#include "engine/terms/potential_check.h"
#include "engine/terms/support.h"
#include "engine/terms/velocity_damping.h"
#include "engine/terms/viscous_boundary.h"

namespace dda {
namespace {

// Sums of a few hundred products of order one, and differences that lose one digit.
constexpr double round_off = 1e-12;

Polygon l_shape() { return {{{0, 0}, {3, 0.2}, {3.1, 1}, {1.2, 1.1}, {1, 2.5}, {-0.1, 2.4}}, {}}; }
Polygon plate_with_hole() {
  return {{{-1, -1}, {2, -0.8}, {2.2, 1.5}, {-0.8, 1.2}}, {{{0, 0}, {0.1, 0.6}, {0.9, 0.5}, {0.8, -0.1}}}};
}
std::vector<Polygon> shapes() { return {l_shape(), plate_with_hole(), {{{5, 5}, {9, 5}, {9, 7}, {5, 7}}, {}}}; }

std::vector<Vec2> vertices_of(const Polygon& shape) {
  std::vector<Vec2> vertices = shape.outer;
  for (const Ring& hole : shape.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
  return vertices;
}

// Integral of a polynomial of second degree over a polygon: the rule of the three edge middles is exact in a triangle.
template <class Value>
Value integral(const Polygon& shape, const Value& zero, const std::function<Value(const Vec2&)>& integrand) {
  const std::vector<Vec2> vertices = vertices_of(shape);
  Value sum = zero;
  for (const Triangle& triangle : triangulate(shape)) {
    const auto corner = [&](int i) {
      return vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
    };
    const Vec2 a = corner(0);
    const Vec2 b = corner(1);
    const Vec2 c = corner(2);
    const double area = ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
    sum += area / 3 * (integrand((a + b) / 2) + integrand((b + c) / 2) + integrand((c + a) / 2));
  }
  return sum;
}

// The motion of a block, written out without displacement_rows: translation + rotation + strain.
Vec2 motion(const Vec6& q, const Vec2& offset) {
  const double x = offset.x();
  const double y = offset.y();
  return {q(0) - q(2) * y + q(3) * x + q(5) / 2 * y, q(1) + q(2) * x + q(4) * y + q(5) / 2 * x};
}

// Six numbers of order one without a pattern.
Vec6 some_unknowns(int seed) {
  Vec6 q;
  for (int i = 0; i < 6; ++i) q(i) = std::sin(12.9 * seed + 7.1 * i * i + i);
  return q;
}

TEST(Inertia, KineticEnergyIsTheIntegralOverTheBody) {
  constexpr double density = 2650;
  for (const Polygon& shape : shapes()) {
    const AreaMoments moments = area_moments(shape);
    const Inertia inertia{density * moments.area, mean_squares(moments), 1};
    for (int seed = 1; seed <= 5; ++seed) {
      const Vec6 v = some_unknowns(seed);
      const double expected = integral<double>(
          shape, 0.0, [&](const Vec2& p) { return density / 2 * motion(v, p - moments.centroid).squaredNorm(); });
      EXPECT_NEAR(v.dot(momentum(inertia, v)) / 2, expected, round_off * expected);
    }
  }
}

TEST(Inertia, MassMatrixIsTheIntegralOfRowsTransposedRows) {
  for (const Polygon& shape : shapes()) {
    const AreaMoments moments = area_moments(shape);
    const Mat6 expected = integral<Mat6>(shape, Mat6::Zero(), [&](const Vec2& p) -> Mat6 {
      const Mat26 rows = displacement_rows(p - moments.centroid);
      return 3 * rows.transpose() * rows;
    });
    const Mat6 mass = mass_matrix({3 * moments.area, mean_squares(moments), 1});
    EXPECT_LT(relative_difference(mass, expected), round_off);
    EXPECT_LT(relative_difference(mass, mass.transpose()), round_off);
  }
}

TEST(Inertia, StrainFactorScalesTheStrainBlockAlone) {
  const AreaMoments moments = area_moments(l_shape());
  const Mat6 once = mass_matrix({moments.area, mean_squares(moments), 1});
  Mat6 expected = once;
  expected.bottomRightCorner<3, 3>() *= 1.7;
  EXPECT_LT(relative_difference(mass_matrix({moments.area, mean_squares(moments), 1.7}), expected), round_off);
}

TEST(Inertia, DeformedSquaresAreThoseOfTheDeformedPolygon) {
  const Mat2 deformation = rotation(0.7) * (Mat2() << 1.2, 0.3, 0.3, 0.8).finished();
  for (Polygon shape : shapes()) {
    const Vec3 deformed = deformed_mean_squares(mean_squares(area_moments(shape)), deformation);
    for (Vec2& vertex : shape.outer) vertex = deformation * vertex;
    for (Ring& hole : shape.holes)
      for (Vec2& vertex : hole) vertex = deformation * vertex;
    EXPECT_LT(relative_difference(deformed, mean_squares(area_moments(shape))), round_off);
  }
}

TEST(Elasticity, StiffnessAndForceFollowFromTheStrainEnergy) {
  for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
    const Mat3 elasticity = elasticity_matrix({"rock", 2600, 7.0, 0.3, plane});
    const Vec3 initial(0.4, -0.7, 0.2);
    constexpr double area = 1.7;
    // Work of the carried stress and of the stress that the strain adds.
    const auto energy = [&](const Vec3& e) { return area * (initial.dot(e) + e.dot(elasticity * e) / 2); };
    EXPECT_LT(relative_difference(strain_stiffness(area, elasticity), hessian<3>(energy, 0.5)), round_off);
    const Vec3 strain(0.3, -0.1, 0.6);
    const Vec3 stress = initial + elasticity * strain;
    EXPECT_LT(relative_difference(stress_force(area, stress), gradient<3>(energy, strain, 0.5)), round_off);
    // The energy of a stress is the energy of the strain it takes to reach it.
    EXPECT_NEAR(strain_energy(area, elasticity * strain, elasticity.inverse()),
                energy(strain) - area * initial.dot(strain), round_off);
  }
}

TEST(Load, IsTheGradientOfItsWork) {
  const Vec2 offset(1.3, -0.4);
  const Vec2 force(5, -7);
  const auto work = [&](const Vec6& q) { return force.dot(motion(q, offset)); };
  EXPECT_LT(relative_difference(point_load(offset, force), gradient<6>(work, some_unknowns(1), 1)), round_off);
}

TEST(Load, EdgeLoadHasTheTractionsResultantMomentAndStrainForces) {
  const Vec2 from(-1, 0.5);
  const Vec2 to(2, 4.5);
  const Vec2 traction(3, -2);
  const Vec6 load = edge_load(from, to, traction);
  EXPECT_NEAR(load(0), 15, round_off * 15);  // 5 m long
  EXPECT_NEAR(load(1), -10, round_off * 15);
  EXPECT_NEAR(load(2), 0.5 * -10 - 2.5 * 15, round_off * 50);  // middle (0.5, 2.5) cross resultant
  // The same by summing point loads along the edge.
  Vec6 sum = Vec6::Zero();
  constexpr int parts = 8;
  for (int i = 0; i < parts; ++i) sum += point_load(from + (i + 0.5) / parts * (to - from), 5.0 / parts * traction);
  EXPECT_LT(relative_difference(load, sum), round_off);
}

TEST(Gravity, PullsAtTheCentroid) { EXPECT_EQ(weight(3, Vec2(1, -9.81)), Vec2(3, 3 * -9.81)); }

TEST(Support, StiffnessIsTheHessianOfItsSprings) {
  const Vec2 offset(0.8, 1.9);
  const Vec2 inclined(0.6, -0.8);
  for (const Mat2& stiffness :
       {Mat2(Vec2(3, 5).asDiagonal()), Mat2(Vec2(0, 5).asDiagonal()), Mat2(7 * inclined * inclined.transpose())}) {
    const auto energy = [&](const Vec6& q) {
      const Vec2 u = motion(q, offset);
      return u.dot(stiffness * u) / 2;
    };
    EXPECT_LT(relative_difference(support_stiffness(displacement_rows(offset), stiffness), hessian<6>(energy, 1)),
              round_off);
  }
}

// Rayleigh function of a dashpot edge by three Gauss points, exact far beyond the square of a linear motion.
double rayleigh_function(const Vec6& v, const Vec2& from, const Vec2& to, double normal, double shear) {
  const double length = (to - from).norm();
  const Vec2 along = (to - from) / length;
  const Vec2 across(along.y(), -along.x());
  double sum = 0;
  for (const auto& [point, weight] :
       {std::pair{-std::sqrt(0.6), 5.0 / 18}, {0.0, 8.0 / 18}, {std::sqrt(0.6), 5.0 / 18}}) {
    const Vec2 u = motion(v, (from + to) / 2 + point * (to - from) / 2);
    sum += weight * (normal * std::pow(across.dot(u), 2) + shear * std::pow(along.dot(u), 2)) / 2;
  }
  return length * sum;
}

TEST(ViscousBoundary, DampingIsTheHessianOfTheRayleighFunction) {
  for (const auto& [from, to] : {std::pair(Vec2(1, -2), Vec2(1, 3)), std::pair(Vec2(-1, 0.3), Vec2(2, 1.4))}) {
    const auto rayleigh = [&, a = from, b = to](const Vec6& v) { return rayleigh_function(v, a, b, 7, 3); };
    EXPECT_LT(relative_difference(viscous_damping(from, to, 7, 3), hessian<6>(rayleigh, 1)), round_off);
  }
}

TEST(ViscousBoundary, NormalImpedanceActsAcrossAndShearImpedanceAlong) {
  const Mat6 damping = viscous_damping({2, -1}, {2, 1}, 7, 3);
  EXPECT_NEAR(damping(0, 0), 14, round_off * 14);  // 2 m of an edge that faces x
  EXPECT_NEAR(damping(1, 1), 6, round_off * 14);
  EXPECT_NEAR(damping(0, 1), 0, round_off * 14);
}

TEST(VelocityDamping, PerStepAndPerTime) {
  EXPECT_DOUBLE_EQ(velocity_factor(0.98, 0, 1e-3), 0.98);
  EXPECT_DOUBLE_EQ(velocity_factor(1, 5, 1e-2), std::exp(-0.05));
  // The rate does the same in one step as in two halves.
  EXPECT_NEAR(velocity_factor(1, 5, 1e-2), std::pow(velocity_factor(1, 5, 5e-3), 2), round_off);
}

}  // namespace
}  // namespace dda
