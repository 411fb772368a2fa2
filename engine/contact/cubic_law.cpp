#include "engine/contact/cubic_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

// True when the interface runs across the centroid line of two blocks that reach equally far from it.
bool is_square_to_chain(const Model& model, const Interface& interface) {
  const double tolerance = 1e-6 * interface.length;
  const Vec2 middle = (interface.from + interface.to) / 2;
  const Vec2 to_a = block_of(model, interface.block_a).moments.centroid - middle;
  const Vec2 to_b = block_of(model, interface.block_b).moments.centroid - middle;
  const double depth_a = -to_a.dot(interface.normal);
  const double depth_b = to_b.dot(interface.normal);
  const bool on_line =
      (to_a + depth_a * interface.normal).norm() < tolerance && (to_b - depth_b * interface.normal).norm() < tolerance;
  // A rectangle's area is its width times twice the depth of its centroid; anything else is no slice of a bar.
  const double slice = 2 * depth_a * interface.length;
  return on_line && std::abs(depth_a - depth_b) < tolerance &&
         std::abs(block_of(model, interface.block_a).moments.area - slice) < 1e-6 * slice &&
         std::abs(block_of(model, interface.block_b).moments.area - slice) < 1e-6 * slice;
}

}  // namespace

double side_free_modulus(const Material& material) {
  const Mat3 elasticity = elasticity_matrix(material);
  return elasticity(0, 0) - elasticity(0, 1) * elasticity(0, 1) / elasticity(1, 1);
}

double cubic_half_distance(const Model& model, const Interface& interface) {
  const Vec2 distance =
      block_of(model, interface.block_b).moments.centroid - block_of(model, interface.block_a).moments.centroid;
  return distance.dot(interface.normal) / 2;
}

double side_free_ratio(const Material& material) {
  const Mat3 elasticity = elasticity_matrix(material);
  return elasticity(0, 1) / elasticity(1, 1);
}

std::vector<bool> cubic_candidates(const Model& model, const std::vector<Interface>& interfaces) {
  std::vector<Vec2> chain(model.blocks.size(), Vec2::Zero());  // direction of the chain through each block
  std::vector<bool> in_chain(model.blocks.size(), true);
  const auto touch_side = [&](int block, const Vec2& along_edge) {
    const auto i = static_cast<std::size_t>(block);
    if (std::abs(chain[i].dot(along_edge.normalized())) > 1e-6) in_chain[i] = false;
  };
  for (const Interface& interface : interfaces) {
    for (const int block : {interface.block_a, interface.block_b}) {
      const auto i = static_cast<std::size_t>(block);
      if (chain[i].isZero()) chain[i] = interface.normal;
      in_chain[i] = in_chain[i] && interface.length > 0 && std::abs(chain[i].dot(interface.normal)) > 1 - 1e-12;
    }
  }
  for (const HeldBlock& held : model.held_blocks) in_chain[static_cast<std::size_t>(held.block)] = false;
  for (const EdgeLoad& load : model.edge_loads) touch_side(load.block, load.to - load.from);
  for (const ViscousEdge& edge : model.viscous_edges) touch_side(edge.block, edge.to - edge.from);
  std::vector<bool> candidates;
  for (const Interface& interface : interfaces) {
    const auto a = static_cast<std::size_t>(interface.block_a);
    const auto b = static_cast<std::size_t>(interface.block_b);
    candidates.push_back(in_chain[a] && in_chain[b] && model.blocks[a].material == model.blocks[b].material &&
                         is_square_to_chain(model, interface));
  }
  return candidates;
}

InterfaceMatrices interface_inertia(const Model& model, const Interface& interface, double period_error, double dt) {
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
  const double lowered = inertia_reduction(model, interface, period_error, dt);
  inertia -= 2 * lowered * between_centroids * between_centroids.transpose();
  inertia -= 2.0 / 3 * std::min(lowered, cubic::most_jump_correction) * jump * jump.transpose();
  inertia *= material.density * interface.length * h;
  return {inertia.topLeftCorner<6, 6>(), inertia.bottomRightCorner<6, 6>(), inertia.bottomLeftCorner<6, 6>()};
}

double inertia_reduction(const Model& model, const Interface& interface, double period_error, double dt) {
  return std::min(period_error * squared_courant_number(model, interface, dt), cubic::most_correction);
}

double load_sharpening(const Model& model, const Interface& interface, double period_error, double dt) {
  return inertia_reduction(model, interface, period_error, dt) / squared_courant_number(model, interface, dt);
}

Vec6 strain_along(const Vec2& direction) {
  const double x = direction.x();
  const double y = direction.y();
  return (Vec6() << 0, 0, 0, x * x, y * y, x * y).finished();
}

Mat6 lateral_inertia(double mass, const AreaMoments& moments, const Vec2& normal) {
  const Vec2 side(-normal.y(), normal.x());
  const Vec6 strain = strain_along(side);
  const double mean_square =
      (side.x() * side.x() * moments.xx + side.y() * side.y() * moments.yy + 2 * side.x() * side.y() * moments.xy) /
      moments.area;
  return mass * mean_square * strain * strain.transpose();
}

double period_error(const Integrator& integrator) {
  const double shift = integrator.gamma - 0.5;
  const double m = integrator.alpha_m;
  const double f = integrator.alpha_f;
  const double damping = f - m - shift;  // first-order numerical damping; it shortens waves too
  return -1.0 / 12 + (0.5 - integrator.gamma + 2 * integrator.beta) / 2 - shift * shift / 2 -
         (m * (1 - m) - f * (1 - f)) / 2 - damping * damping / 4;
}

}  // namespace dda
