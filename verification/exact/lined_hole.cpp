#include "verification/exact/lined_hole.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace exact {
namespace {

double plane_modulus(const LinedHole& hole) {
  return hole.lining_young / (1 - hole.lining_poisson * hole.lining_poisson);
}

// Pressure of the thin ring on the rock for each metre that the wall goes inwards.
double ring_stiffness(const LinedHole& hole) {
  return plane_modulus(hole) * hole.thickness / (hole.radius * hole.radius);
}

// Displacements r^m cos(2 angle) and ratio r^m sin(2 angle) of the rock, and the stresses that go with them: radial
// with cos, shear with sin.
struct Solution {
  double power = 0, ratio = 0;
  double shear = 0, lame = 0;  // Pa, Lame's constants

  [[nodiscard]] double size(double r) const { return std::pow(r, power); }
  [[nodiscard]] double radial_stress(double r) const {
    const double dilation = (power + 1 + 2 * ratio) * size(r) / r;
    return lame * dilation + 2 * shear * power * size(r) / r;
  }
  [[nodiscard]] double shear_stress(double r) const { return shear * (ratio * (power - 1) - 2) * size(r) / r; }
};

// Radial equilibrium, (lame + 2 G) d(dilation)/dr = (4 G/r) (rotation), asks for this ratio.
Solution solution(const LinedHole& hole, double power) {
  const double shear = hole.rock_young / (2 * (1 + hole.rock_poisson));
  const double lame = 2 * shear * hole.rock_poisson / (1 - 2 * hole.rock_poisson);
  const double p_modulus = lame + 2 * shear;
  const double ratio =
      (4 * shear - p_modulus * (power * power - 1)) / (2 * p_modulus * (power - 1) - 2 * shear * (power + 1));
  return {power, ratio, shear, lame};
}

}  // namespace

double wall_compliance(const LinedHole& hole) {
  const double a2 = hole.radius * hole.radius;
  const double b2 = hole.outer_radius * hole.outer_radius;
  return (1 + hole.rock_poisson) / hole.rock_young * hole.radius * ((1 - 2 * hole.rock_poisson) * a2 + b2) / (b2 - a2);
}

namespace {

// The thrust of a ring that answers with `stiffness`: its part of the pressure that the wall has left, times the
// radius.
double thrust_of_ring(const LinedHole& hole, double pressure, double stiffness) {
  const double stiffer = stiffness * wall_compliance(hole);
  return hole.radius * (1 - hole.let_go) * pressure * stiffer / (1 + stiffer);
}

}  // namespace

double thick_ring_thrust(const LinedHole& hole) {
  const double a2 = hole.radius * hole.radius;
  const double c2 = (hole.radius - hole.thickness) * (hole.radius - hole.thickness);
  const double compliance = (1 + hole.lining_poisson) / hole.lining_young * hole.radius *
                            ((1 - 2 * hole.lining_poisson) * a2 + c2) / (a2 - c2);
  return thrust_of_ring(hole, -hole.stress_xx, 1 / compliance);
}

CrushedRing crushed_ring(const LinedHole& hole, double crushing) {
  const double left = (1 - hole.let_go) * -hole.stress_xx;
  const double convergence = wall_compliance(hole) * (left - crushing / hole.radius);
  const double elastic = crushing / (ring_stiffness(hole) * hole.radius);
  return {convergence, 2 * std::numbers::pi * crushing * (convergence - elastic)};
}

RingForces lining_forces(const LinedHole& hole) {
  const double a = hole.radius;
  const double axial = plane_modulus(hole) * hole.thickness;
  const double bending = axial * hole.thickness * hole.thickness / 12;
  const double mean = (hole.stress_xx + hole.stress_yy) / 2;
  const double left = (1 - hole.let_go) * (hole.stress_xx - hole.stress_yy) / 2;

  // After the lining has come the stress on the wall changes from `left` to what the ring exerts, and nothing outside.
  Eigen::Matrix4d equations;
  Eigen::RowVector4d stretch, bend;  // a times the ring's strain, a^2 times its change of curvature
  const double powers[] = {1, 3, -1, -3};
  for (int i = 0; i < 4; ++i) {
    const Solution s = solution(hole, powers[i]);
    stretch(i) = (1 + 2 * s.ratio) * s.size(a);
    bend(i) = (4 + 2 * s.ratio) * s.size(a);
    const double outwards = axial / (a * a) * stretch(i) + 4 * bending / std::pow(a, 4) * bend(i);
    const double along = 2 * axial / (a * a) * stretch(i) + 2 * bending / std::pow(a, 4) * bend(i);
    equations.col(i) << s.radial_stress(a) - outwards, s.shear_stress(a) - along, s.radial_stress(hole.outer_radius),
        s.shear_stress(hole.outer_radius);
  }
  const Eigen::Vector4d factors = equations.fullPivLu().solve(Eigen::Vector4d(-left, left, 0, 0));

  RingForces forces;
  forces.thrust_0 = thrust_of_ring(hole, -mean, ring_stiffness(hole));
  forces.thrust_2 = -axial / a * stretch * factors;
  forces.moment_2 = -bending / (a * a) * bend * factors;
  return forces;
}

}  // namespace exact
