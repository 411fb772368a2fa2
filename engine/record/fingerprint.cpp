#include "engine/model/rock_change.h"
#include "engine/record/checkpoint.h"
#include "engine/record/fnv_hash.h"

namespace dda {
namespace {

void add(FnvHash& hash, const Ring& ring) {
  hash.add_number(ring.size());
  for (const Vec2& vertex : ring) {
    hash.add_number(vertex.x());
    hash.add_number(vertex.y());
  }
}

void add(FnvHash& hash, const Block& block) {
  hash.add_number(block.material);
  add(hash, block.shape.outer);
  hash.add_number(block.shape.holes.size());
  for (const Ring& hole : block.shape.holes) add(hash, hole);
}

// A new member of a material breaks the lines that unpack it, so that it is not forgotten here.
void add(FnvHash& hash, const Material& material) {
  const auto& [name, density, young, poisson, plane] = material;
  hash.add_number(plane);
  for (const double value : {density, young, poisson}) hash.add_number(value);
}

void add(FnvHash& hash, const JointMaterial& joint) {
  const auto& [name, law, bonded, friction_angle, cohesion, tensile_strength, residual_friction_angle,
               residual_cohesion, dilation_angle, zero_dilation_slip, normal_spring, spring_over_young, shear_to_normal,
               normal_stiffness, shear_stiffness, automatic_stiffness, contact_damping, penalty, stabilisation] = joint;
  hash.add_number(law);
  hash.add_number(bonded);
  hash.add_number(automatic_stiffness);
  hash.add_number(stabilisation.has_value());
  for (const double value :
       {friction_angle, cohesion, tensile_strength, residual_friction_angle.value_or(friction_angle), residual_cohesion,
        dilation_angle, zero_dilation_slip, normal_spring, spring_over_young, shear_to_normal, normal_stiffness,
        shear_stiffness, contact_damping, penalty, stabilisation_of(joint)}) {
    hash.add_number(value);
  }
}

void add(FnvHash& hash, const BoltLink& link) {
  for (const int block : {link.block_a, link.block_b}) hash.add_number(block);
  for (const Vec2& point : {link.point_a, link.point_b}) {
    hash.add_number(point.x());
    hash.add_number(point.y());
  }
  for (const double stiffness : {link.axial_stiffness, link.shear_stiffness}) hash.add_number(stiffness);
}

void add(FnvHash& hash, const LiningNode& node) {
  hash.add_number(node.block);
  for (const double value : {node.point.x(), node.point.y(), node.tangent.x(), node.tangent.y()})
    hash.add_number(value);
}

template <typename Item>
void add_all(FnvHash& hash, const std::vector<Item>& items) {
  hash.add_number(items.size());
  for (const Item& item : items) add(hash, item);
}

void add(FnvHash& hash, const Bolt& bolt) {
  hash.add_number(bolt.grouted);
  hash.add_number(bolt.pretension);
  add_all(hash, bolt.links);
}

void add(FnvHash& hash, const Lining& lining) {
  hash.add_number(lining.closed);
  for (const double value : {lining.thickness, lining.young, lining.poisson}) hash.add_number(value);
  add_all(hash, lining.nodes);
}

void add(FnvHash& hash, const std::vector<double>& numbers) {
  hash.add_number(numbers.size());
  for (const double number : numbers) hash.add_number(number);
}

// What was recorded; other histories may change on the way.
void add(FnvHash& hash, const TimeFunction& history) {
  const auto* recorded = std::get_if<Recorded>(&history);
  if (recorded == nullptr) return;
  hash.add_number(recorded->start);
  add(hash, recorded->recording->times());
  add(hash, recorded->recording->values());
}

// A run may have changed what the model says of its rock: what it began with counts, and what each stage makes of it.
void add_rock(FnvHash& hash, const Model& model) {
  add_all(hash, materials_in(model, 0));
  add_all(hash, joints_in(model, 0));
  for (std::size_t i = 1; i < model.stages.size(); ++i) {
    const auto& [materials, joints, added] = model.stages[i].rock;
    if (materials.empty() && joints.empty() && added.empty()) continue;
    hash.add_number(i);
    add_all(hash, materials);
    add_all(hash, joints);
    for (const int block : added) hash.add_number(block);
  }
}

}  // namespace

std::uint64_t fingerprint(const Model& model) {
  FnvHash hash;
  add_all(hash, model.blocks);
  add_rock(hash, model);
  for (const auto& [blocks, joint] : model.joint_of_block_pair) {
    for (const int index : {blocks.first, blocks.second, joint}) hash.add_number(index);
  }
  for (const JointLine& line : model.joint_lines) {
    for (const double value : {line.from.x(), line.from.y(), line.to.x(), line.to.y()}) hash.add_number(value);
    hash.add_number(line.joint);
  }
  for (const PointLoad& load : model.point_loads) add(hash, load.history);
  for (const EdgeLoad& load : model.edge_loads) add(hash, load.history);
  for (const PointSupport& support : model.supports) add(hash, support.history);
  for (const Bolt& bolt : model.bolts) add(hash, bolt);
  for (const Lining& lining : model.linings) add(hash, lining);
  for (const HeldBlock& held : model.held_blocks) {
    hash.add_number(held.block);
    add(hash, held.history);
  }
  return hash.value();
}

}  // namespace dda
