#include "engine/waves/chain_end.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/cubic_law.h"
#include "engine/waves/cubic_inertia.h"

namespace dda {
namespace {

constexpr double missing_share = 1 - cubic::end_share;

bool holds_along(const PointSupport& support, const Vec2& direction) {
  constexpr double tolerance = 1e-9;  // of a unit vector
  if (!support.direction.isZero()) return std::abs(support.direction.dot(direction)) > tolerance;
  return (support.holds_x && std::abs(direction.x()) > tolerance) ||
         (support.holds_y && std::abs(direction.y()) > tolerance);
}

bool is_held(const Model& model, int block, const Vec2& direction) {
  return std::any_of(model.viscous_edges.begin(), model.viscous_edges.end(),
                     [&](const ViscousEdge& edge) { return edge.block == block; }) ||
         std::any_of(model.supports.begin(), model.supports.end(), [&](const PointSupport& support) {
           return support.block == block && holds_along(support, direction);
         });
}

// What sigma_nn would be if the block's sides were free, Pa: Q times the strain along the chain.
double axial_stress(const Material& material, const Vec2& n, const Vec3& stress) {
  const Vec3 along(n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y());
  const Vec3 across(n.y() * n.y(), n.x() * n.x(), -2 * n.x() * n.y());
  return (along - side_free_ratio(material) * across).dot(stress);
}

double missing_area(const ChainEnd& end) { return missing_share * end.half_length * end.width; }

}  // namespace

std::vector<ChainEnd> free_chain_ends(const Model& model, const std::vector<Interface>& interfaces,
                                      const InterfaceElements& elements) {
  std::vector<int> neighbours(model.blocks.size(), 0);
  for (const Interface& interface : interfaces)
    for (const int block : {interface.block_a, interface.block_b}) ++neighbours[static_cast<std::size_t>(block)];
  std::vector<ChainEnd> ends;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    if (elements.but_for_blocks(i).law != InterfaceLaw::cubic) continue;
    const Interface& interface = interfaces[i];
    const double half = cubic_half_distance(model, interface);
    const auto add = [&](int block, const Vec2& outward) {
      if (neighbours[static_cast<std::size_t>(block)] == 1 && !is_held(model, block, outward))
        ends.push_back({block, i, outward, half, interface.length});
    };
    add(interface.block_a, -interface.normal);
    add(interface.block_b, interface.normal);
  }
  return ends;
}

Mat6 end_stiffness(const Model& model, const ChainEnd& end) {
  const Vec6 strain = strain_along(end.outward);
  return -missing_area(end) * side_free_modulus(model.material_of(end.block)) * strain * strain.transpose();
}

Mat6 end_inertia(const Model& model, const ChainEnd& end, const Interface& interface, double period_error, double dt) {
  const double lowered = std::min(cubic_inertia_share(model, interface, period_error, dt), cubic::most_jump_correction);
  const double block_length = 2 * end.half_length;
  const double mass = cubic::end_share * model.material_of(end.block).density * end.half_length * end.width;
  const Vec6 strain = strain_along(end.outward);
  return -lowered * mass * block_length * block_length * strain * strain.transpose();
}

Vec6 end_force(const Model& model, const ChainEnd& end, const Vec3& stress) {
  const double axial = axial_stress(model.material_of(end.block), end.outward, stress);
  return -missing_area(end) * axial * strain_along(end.outward);
}

double end_energy(const Model& model, const ChainEnd& end, const Vec3& stress) {
  const Material& material = model.material_of(end.block);
  const double axial = axial_stress(material, end.outward, stress);
  return -missing_area(end) * axial * axial / (2 * side_free_modulus(material));
}

Vec6 end_load(const ChainEnd& end, const Vec2& offset, const Vec2& force) {
  const double lever = std::max(offset.dot(end.outward), 0.0);
  return -missing_share * lever * force.dot(end.outward) * strain_along(end.outward);
}

}  // namespace dda
