#include "engine/scene/block_group.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/stress_field.h"

namespace dda {
namespace {

std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  return names;
}

int read_material_reference(const Field& owner, const Model& model) {
  if (const auto field = owner.find("material")) return material_named(*field, model);
  if (model.materials.size() == 1) return 0;
  throw InputError("", owner.path() + ".material", "missing", "one of the names in materials, as there are several");
}

}  // namespace

// Materials of a scene are the members of a JSON object, which come in the order of their names.
int material_named(const Field& name, const Model& model) {
  const auto found = std::ranges::lower_bound(model.materials, name.text(), {}, &Material::name);
  if (found != model.materials.end() && found->name == name.text())
    return static_cast<int>(found - model.materials.begin());
  return static_cast<int>(name.choice(names_of(model.materials)));  // throws, as none is it
}

BlockGroup read_group(const Field& field, std::string default_name, const Model& model) {
  BlockGroup group;
  group.name = value_or(field, "name", std::move(default_name), [](const Field& f) { return f.name(); });
  group.material = read_material_reference(field, model);
  group.initial_stress = value_or(field, "initial_stress", group.initial_stress, read_stress);
  group.initial_velocity = value_or(field, "initial_velocity", group.initial_velocity,
                                    [](const Field& f) { return f.vector(Dimension::velocity); });
  group.initial_spin =
      value_or(field, "initial_spin", 0.0, [](const Field& f) { return f.quantity(Dimension::angular_velocity); });
  return group;
}

Block block_of(const BlockGroup& group, std::string name) {
  Block block;
  block.name = std::move(name);
  block.material = group.material;
  block.initial_stress = group.initial_stress;
  block.initial_velocity = group.initial_velocity;
  block.initial_spin = group.initial_spin;
  return block;
}

Ring read_ring(const Field& field) {
  Ring ring;
  for (const Field& vertex : field.items()) ring.push_back(vertex.vector(Dimension::length));
  return ring;
}

}  // namespace dda
