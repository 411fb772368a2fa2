#include "engine/contact/cubic_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dda {
namespace {

const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

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

Vec6 strain_along(const Vec2& direction) {
  const double x = direction.x();
  const double y = direction.y();
  return (Vec6() << 0, 0, 0, x * x, y * y, x * y).finished();
}

}  // namespace dda
