#include "engine/waves/cubic_inertia.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/cubic_law.h"

namespace dda {
namespace {

const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

// Rows over the six unknowns of one block: normal displacement at mid-interface, and h times the normal strain.
struct NormalRows {
  Vec6 displacement;
  Vec6 strain;
};

NormalRows normal_rows(const Interface& interface, const Vec2& centroid, double half) {
  const Vec2& n = interface.normal;
  NormalRows rows;
  rows.displacement = displacement_rows((interface.from + interface.to) / 2 - centroid).transpose() * n;
  rows.strain = half * strain_along(n);
  return rows;
}

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

Vec12 joined(const Vec6& a, const Vec6& b) { return (Vec12() << a, b).finished(); }

Mat12 symmetric_product(const Vec12& x, const Vec12& y) { return x * y.transpose() + y * x.transpose(); }

// (c dt/2h)^2
double squared_courant_number(const Model& model, const Interface& interface, double dt) {
  const Material& material = model.material_of(interface.block_a);
  const double distance = 2 * cubic_half_distance(model, interface);
  return side_free_modulus(material) / material.density * dt * dt / (distance * distance);
}

}  // namespace

InterfaceMatrices cubic_inertia(const Model& model, const Interface& interface, double period_error, double dt) {
  const double h = cubic_half_distance(model, interface);
  const Material& material = model.material_of(interface.block_a);
  const NormalRows a = normal_rows(interface, block_of(model, interface.block_a).moments.centroid, h);
  const NormalRows b = normal_rows(interface, block_of(model, interface.block_b).moments.centroid, h);
  const Vec12 gap = joined(-a.displacement, b.displacement);
  const Vec12 jump = joined(-a.strain, b.strain);
  const Vec12 mean_displacement = joined(a.displacement, b.displacement) / 2;
  const Vec12 mean_strain = joined(a.strain, b.strain) / 2;
  const Vec12 between_centroids = gap + 2 * mean_strain;

  Mat12 inertia = 2 * (33.0 / 560 - 3.0 / 16) * gap * gap.transpose();
  inertia += 2 * (1.0 / 48 + 1.0 / 80) * jump * jump.transpose();
  inertia += symmetric_product(jump, mean_displacement) / 6;
  inertia -= symmetric_product(gap, mean_strain) / 10;
  const double lowered = cubic_inertia_share(model, interface, period_error, dt);
  inertia -= 2 * lowered * between_centroids * between_centroids.transpose();
  inertia -= 2.0 / 3 * std::min(lowered, cubic::most_jump_correction) * jump * jump.transpose();
  inertia *= material.density * interface.length * h;
  return {inertia.topLeftCorner<6, 6>(), inertia.bottomRightCorner<6, 6>(), inertia.bottomLeftCorner<6, 6>()};
}

double cubic_inertia_share(const Model& model, const Interface& interface, double period_error, double dt) {
  return std::min(period_error * squared_courant_number(model, interface, dt), cubic::most_correction);
}

double cubic_load_sharpening(const Model& model, const Interface& interface, double period_error, double dt) {
  return cubic_inertia_share(model, interface, period_error, dt) / squared_courant_number(model, interface, dt);
}

Mat6 lateral_inertia(double mass, const AreaMoments& moments, const Vec2& normal) {
  const Vec2 side(-normal.y(), normal.x());
  const Vec6 strain = strain_along(side);
  const double mean_square =
      (side.x() * side.x() * moments.xx + side.y() * side.y() * moments.yy + 2 * side.x() * side.y() * moments.xy) /
      moments.area;
  return mass * mean_square * strain * strain.transpose();
}

}  // namespace dda
