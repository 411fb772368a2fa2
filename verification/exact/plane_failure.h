// A block on a plane that dips at psi, held by cohesion c (Pa) over the area A (m2) and friction f (rad) under its
// weight W (N): factor of safety (c A + W cos psi tan f)/(W sin psi) (Hoek and Bray 1981, chapter 7, dry slope).
#pragma once

#include <cmath>

namespace exact {

struct PlaneFailure {
  double dip = 0;     // psi, rad
  double area = 0;    // m2 (per m of thickness)
  double weight = 0;  // N

  [[nodiscard]] double safety(double cohesion, double friction) const {
    return (cohesion * area + weight * std::cos(dip) * std::tan(friction)) / (weight * std::sin(dip));
  }
  // Where the factor of safety is 1; the other strength given.
  [[nodiscard]] double limiting_cohesion(double friction) const {
    return weight * (std::sin(dip) - std::cos(dip) * std::tan(friction)) / area;
  }
  [[nodiscard]] double limiting_friction(double cohesion) const {
    return std::atan((weight * std::sin(dip) - cohesion * area) / (weight * std::cos(dip)));
  }
};

}  // namespace exact
