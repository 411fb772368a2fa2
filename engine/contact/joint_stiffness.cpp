#include "engine/contact/joint_stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"

namespace dda {
namespace {

double softer_young(const Model& model, const Interface& interface) {
  return std::min(model.material_at_start(interface.block_a).young, model.material_at_start(interface.block_b).young);
}

// A lower bound of the width of a block in any direction: its area over the diameter of a disk that holds it.
double thickness(const Block& block) {
  double radius = 0;
  for (const Vec2& vertex : block.shape.outer) radius = std::max(radius, (vertex - block.moments.centroid).norm());
  return block.moments.area / (2 * radius);
}

// Static steps may be as long as they like: nothing swings in them, and what they find is for stages that move. Where
// steps grow, the first ones say how fast what swings is.
double longest_step(const Model& model) {
  double dt = 0;
  for (const Stage& stage : model.stages)
    if (!stage.integrator.is_static) dt = std::max(dt, stage.shortest_dt());
  return dt;
}

// m, of the joint, for which each spring of an interface stands; of moving contacts at least what a point stands for.
double length_of_spring(const Model& model, const Interface& interface) {
  if (interface.length > 0) return interface.share;
  const double smaller =
      std::min(block_size(block_of(model, interface.block_a)), block_size(block_of(model, interface.block_b)));
  return std::max(interface.share, point_share * smaller);
}

double chosen_spring(const Model& model, const Interface& interface) {
  const double across =
      std::min(thickness(block_of(model, interface.block_a)), thickness(block_of(model, interface.block_b)));
  const double per_area = std::max(softer_young(model, interface) / (compliance_target * across),
                                   model.expected.pressure / (penetration_target * across));
  const double mass = std::min(model.mass_at_start(interface.block_a), model.mass_at_start(interface.block_b));
  const double dt = longest_step(model);
  const double wanted = per_area * length_of_spring(model, interface);
  return dt > 0 ? std::min(wanted, largest_chi * mass / (dt * dt)) : wanted;
}

// Springs that go by the sizes of blocks, in multiples of the modulus: the thesis' g0 at least, and at most what keeps
// the digits of a solve where splinters touch (1,000 made the matrix of one rock of 200 indefinite by round-off).
constexpr double least_over_young = 10, most_over_young = 300;

double larger_over_smaller(const Model& model, const Interface& interface) {
  const double a = block_size(block_of(model, interface.block_a)), b = block_size(block_of(model, interface.block_b));
  return std::max(a, b) / std::min(a, b);
}

// An end that rides up as it slides turns slip into closing, and a spring that is much stiffer in that than in shear
// leaves passes nothing to converge to.
Springs springs_by_sizes(const Model& model, const Interface& interface, const JointMaterial& joint) {
  const double ratio = joint.dilation_angle > 0 ? 1 : larger_over_smaller(model, interface);
  const double over_young = std::clamp(ratio, least_over_young, most_over_young);
  const double young = softer_young(model, interface);
  return {over_young * young, joint.shear_to_normal * std::sqrt(least_over_young * over_young) * young};
}

}  // namespace

Springs springs_of(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  double normal = joint.normal_spring;
  if (joint.automatic_stiffness) {
    normal = chosen_spring(model, interface);
    const Springs least = springs_by_sizes(model, interface, joint);
    if (joint.law == InterfaceLaw::projected && least.normal > normal) return least;
  } else if (joint.normal_stiffness > 0) {
    normal = joint.normal_stiffness * length_of_spring(model, interface);
  } else if (normal == 0) {
    if (joint.spring_over_young == 0) return springs_by_sizes(model, interface, joint);
    normal = joint.spring_over_young * softer_young(model, interface);
  }
  return {normal, joint.shear_stiffness > 0 ? joint.shear_stiffness * length_of_spring(model, interface)
                                            : joint.shear_to_normal * normal};
}

// Blocks that cannot give way sideways have the modulus of plane strain in a layer, and joints between them have more
// of the whole compliance than between others.
StiffnessErrors stiffness_errors(const Model& model, const Interface& interface) {
  const auto half_block = [&](int block) {
    return width_across(model, block, interface.normal) / (2 * plane_modulus(model.material_at_start(block)));
  };
  const double per_area = 2 * springs_of(model, interface).normal / interface.length;
  const double smaller =
      std::min(block_size(block_of(model, interface.block_a)), block_size(block_of(model, interface.block_b)));
  return {1 / (per_area * (half_block(interface.block_a) + half_block(interface.block_b))),
          model.expected.pressure / (per_area * smaller)};
}

double block_size(const Block& block) { return std::sqrt(block.moments.area); }

}  // namespace dda
