#include "engine/contact/cubic_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"

namespace dda {
namespace {

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

// Which blocks belong to a chain whose sides are free: strains across it follow from those along it only where nothing
// presses or holds the sides. Blocks pass strains across on to their neighbours, so what touches one side of one block
// concerns the whole chain.
class ChainBlocks {
 public:
  ChainBlocks(const Model& model, const std::vector<Interface>& interfaces)
      : model_(model),
        outward_(model.blocks.size(), Vec2::Zero()),
        neighbours_(model.blocks.size()),
        in_chain_(model.blocks.size(), true) {
    for (const Interface& interface : interfaces) {
      add(interface.block_a, interface.block_b, -interface.normal, interface.length);
      add(interface.block_b, interface.block_a, interface.normal, interface.length);
    }
    for (const HeldBlock& held : model.held_blocks) hold(held.block);
    for (const EdgeLoad& load : model.edge_loads) touch_along(load.block, load.to - load.from);
    for (const ViscousEdge& edge : model.viscous_edges) touch_along(edge.block, edge.to - edge.from);
    for (const PointLoad& load : model.point_loads) touch_at(load.block, load.point, across(load));
    for (const PointSupport& support : model.supports) touch_at(support.block, support.point, across(support));
  }

  [[nodiscard]] bool has(int block) const { return in_chain_[at(block)]; }

 private:
  static constexpr double angle_tolerance = 1e-6;

  static std::size_t at(int block) { return static_cast<std::size_t>(block); }

  void leave(int block) { in_chain_[at(block)] = false; }

  // A rigid end keeps what it is bonded to from swelling.
  void hold(int block) {
    leave(block);
    for (const int next : neighbours_[at(block)])
      if (model_.material_of(next).poisson != 0) leave_with_chain(next);
  }

  void leave_with_chain(int first) {
    std::vector<int> waiting = {first};
    while (!waiting.empty()) {
      const int block = waiting.back();
      waiting.pop_back();
      if (!has(block)) continue;
      leave(block);
      const std::vector<int>& next = neighbours_[at(block)];
      waiting.insert(waiting.end(), next.begin(), next.end());
    }
  }

  // `outward`: along the chain, away from this neighbour.
  void add(int block, int neighbour, const Vec2& outward, double length) {
    Vec2& known = outward_[at(block)];
    if (known.isZero()) known = outward;
    neighbours_[at(block)].push_back(neighbour);
    if (length == 0 || std::abs(known.dot(outward)) <= 1 - 1e-12) leave(block);
  }

  void touch_along(int block, const Vec2& edge) {
    if (std::abs(outward_[at(block)].dot(edge.normalized())) > angle_tolerance) leave_with_chain(block);
  }

  // A force across the chain strains a block that way, unless it acts on the chain's axis or on its end face.
  void touch_at(int block, const Vec2& point, bool acts_across) {
    if (!acts_across) return;
    const AreaMoments& moments = block_of(model_, block).moments;
    const Vec2& along = outward_[at(block)];
    const Vec2 offset = point - moments.centroid;
    const double tolerance = angle_tolerance * std::sqrt(moments.area);
    const double face = extent_along(block_of(model_, block).shape.outer, along) / 2;
    const bool on_end_face = neighbours_[at(block)].size() == 1 && offset.dot(along) > face - tolerance;
    if (std::abs(offset.dot(along.unitOrthogonal())) > tolerance && !on_end_face) leave_with_chain(block);
  }

  [[nodiscard]] bool is_across(int block, const Vec2& direction) const {
    const Vec2& along = outward_[at(block)];
    return !along.isZero() && std::abs(along.unitOrthogonal().dot(direction)) > angle_tolerance * direction.norm();
  }

  [[nodiscard]] bool across(const PointLoad& load) const { return is_across(load.block, load.force); }

  [[nodiscard]] bool across(const PointSupport& support) const {
    if (!support.direction.isZero()) return is_across(support.block, support.direction);
    return (support.holds_x && is_across(support.block, Vec2::UnitX())) ||
           (support.holds_y && is_across(support.block, Vec2::UnitY()));
  }

  const Model& model_;
  std::vector<Vec2> outward_;  // along the chain, away from the first neighbour; zero where there is none
  std::vector<std::vector<int>> neighbours_;
  std::vector<bool> in_chain_;
};

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
  const auto is_cubic = [](const JointMaterial& joint) { return joint.law == InterfaceLaw::cubic; };
  if (std::ranges::none_of(model.joints, is_cubic)) return std::vector<bool>(interfaces.size(), false);
  const ChainBlocks chains(model, interfaces);
  std::vector<bool> candidates;
  for (const Interface& interface : interfaces) {
    const Block& a = block_of(model, interface.block_a);
    const Block& b = block_of(model, interface.block_b);
    candidates.push_back(chains.has(interface.block_a) && chains.has(interface.block_b) && a.material == b.material &&
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
