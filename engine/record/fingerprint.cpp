#include "dda/record/checkpoint.h"
#include "dda/record/fnv_hash.h"

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

void add(FnvHash& hash, const Material& material) {
  hash.add_number(material.plane);
  for (const double value : {material.density, material.young, material.poisson}) hash.add_number(value);
}

void add(FnvHash& hash, const JointMaterial& joint) {
  hash.add_number(joint.law);
  hash.add_number(joint.bonded);
  for (const double value : {joint.friction_angle, joint.cohesion, joint.tensile_strength, joint.normal_spring,
                             joint.spring_over_young, joint.shear_to_normal, joint.penalty, joint.stabilisation}) {
    hash.add_number(value);
  }
}

template <typename Item>
void add_all(FnvHash& hash, const std::vector<Item>& items) {
  hash.add_number(items.size());
  for (const Item& item : items) add(hash, item);
}

}  // namespace

std::uint64_t fingerprint(const Model& model) {
  FnvHash hash;
  add_all(hash, model.blocks);
  add_all(hash, model.materials);
  add_all(hash, model.joints);
  for (const auto& [blocks, joint] : model.joint_of_block_pair) {
    for (const int index : {blocks.first, blocks.second, joint}) hash.add_number(index);
  }
  return hash.value();
}

}  // namespace dda
