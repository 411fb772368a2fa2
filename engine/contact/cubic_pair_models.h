// For tests: two blocks of a cubic chain, and the Hermite cubic between their centroids, integrated by Gauss
// quadrature.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/contact/contact_models.h"
#include "engine/contact/interface_element.h"

namespace dda::cubic_pair {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

inline constexpr double length = 1.6;  // of a block, along the chain
inline constexpr double width = 0.9;   // of the chain
inline constexpr std::array angles = {0.0, 0.4, 1.9, -2.6};

inline Model pair_of(const Material& material, double angle) {
  Model model = model_of({{box_ring(0, 0, length, width), {}}, {box_ring(length, 0, 2 * length, width), {}}}, material);
  model.joints[0].law = InterfaceLaw::cubic;
  model.joints[0].bonded = true;
  place(model, angle, Vec2(3, -2));
  return model;
}

// What the cubic needs of a block: displacement and strains in axes along and across the chain.
struct AxialMotion {
  AxialMotion(const Vec6& q, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    displacement = c * q(0) + s * q(1);
    strain = c * c * q(3) + s * s * q(4) + c * s * q(5);
    lateral = s * s * q(3) + c * c * q(4) - c * s * q(5);
  }
  double displacement, strain, lateral;
};

// Hermite cubic over the cell of length `length` between centroids, t from 0 (block a) to 1 (block b).
struct Hermite {
  AxialMotion a, b;
  [[nodiscard]] double value(double t) const {
    return (1 + 2 * t) * (1 - t) * (1 - t) * a.displacement + t * (1 - t) * (1 - t) * length * a.strain +
           t * t * (3 - 2 * t) * b.displacement + t * t * (t - 1) * length * b.strain;
  }
  [[nodiscard]] double slope(double t) const {
    return 6 * t * (1 - t) * (b.displacement - a.displacement) / length + (1 - t) * (1 - 3 * t) * a.strain +
           t * (3 * t - 2) * b.strain;
  }
};

// Integral over the half [first, first + 1/2] of the cell; four points are exact to degree 7.
template <class Function>
double half_cell(double first, const Function& integrand) {
  constexpr std::array points = {0.861136311594052575, 0.339981043584856265};
  constexpr std::array weights = {0.347854845137453857, 0.652145154862546143};
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (const double sign : {-1.0, 1.0}) sum += weights[i] * integrand(first + (1 + sign * points[i]) / 4);
  return sum * length / 4;
}

inline Hermite hermite(const Vec12& q, double angle) {
  return {AxialMotion(q.head<6>(), angle), AxialMotion(q.tail<6>(), angle)};
}

inline Vec12 some_motion(int seed) {
  Vec12 q;
  for (int i = 0; i < 12; ++i) q(i) = std::sin(3.7 * seed + 5.3 * i * i + i);
  return q;
}

inline Mat12 joined(const InterfaceMatrices& m) { return (Mat12() << m.aa, m.ba.transpose(), m.ba, m.bb).finished(); }

inline std::array<Material, 2> materials() {
  return {Material{"stress", 2.3, 5.0, 0.3, PlaneState::stress},
          Material{"strain", 2.3, 5.0, 0.35, PlaneState::strain}};
}

}  // namespace dda::cubic_pair
