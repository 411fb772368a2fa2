// Stages that change the rock: `"joints"` and `"materials"` of a stage, by the names of the scene.
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/check_parts.h"
#include "engine/model/rock_change.h"
#include "engine/scene/rock_values.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

template <typename Item>
Item& item_called(const std::string& name, const Field& field, std::vector<Item>& items) {
  const auto found = std::ranges::find(items, name, &Item::name);
  if (found == items.end()) field.fail("\"" + name + "\"", "a name that the scene gives");
  return *found;
}

double read_stress(const Field& field) { return field.not_negative(Dimension::stress); }

void read_change(const Field& field, JointMaterial& joint) {
  if (joint.bonded) field.fail("of bonded joint", "a joint that has a strength: nothing parts or slides in this one");
  const bool was_dry = is_dry(joint);
  joint.friction_angle = value_or(field, "friction_angle", joint.friction_angle, read_friction_angle);
  joint.cohesion = value_or(field, "cohesion", joint.cohesion, read_stress);
  joint.tensile_strength = value_or(field, "tensile_strength", joint.tensile_strength, read_stress);
  if (const auto angle = field.find("residual_friction_angle"))
    joint.residual_friction_angle = read_friction_angle(*angle);
  joint.residual_cohesion = value_or(field, "residual_cohesion", joint.residual_cohesion, read_stress);
  if (was_dry && !is_dry(joint))
    field.fail("with cohesion or tensile strength", "none, as the joint had: a dry joint has no bond that could grow");
}

void read_change(const Field& field, Material& material) {
  if (const auto young = field.find("young")) material.young = young->positive(Dimension::stress);
  if (const auto poisson = field.find("poisson")) material.poisson = read_poisson(*poisson, material.plane);
}

// Here, where the entry can be named.
void check_growth(const Field& changes, const std::vector<Material>& now, const Model& model) {
  const model_checks::ModulusLimits limits = model_checks::modulus_limits(model);
  for (const auto& [name, change] : changes.members()) {
    const auto place = std::ranges::find(now, name, &Material::name);
    const Material& start = materials_in(model, 0)[static_cast<std::size_t>(place - now.begin())];
    const auto problem = model_checks::problem_of_growth(limits, model_checks::modulus_growth(start, *place));
    const Field& field = change;
    const Field culprit = field.has("young") ? field.at("young") : field;
    if (problem) culprit.fail(problem->first, problem->second);
  }
}

template <typename Item>
std::vector<Item> changed(const Field& field, std::vector<Item> items) {
  for (const auto& [name, change] : field.members()) read_change(change, item_called(name, field, items));
  return items;
}

}  // namespace

RockOfStage read_rock_changes(const Field& step, const Model& model) {
  RockOfStage rock;
  const auto joints = step.find("joints");
  const auto materials = step.find("materials");
  for (const auto& each : {joints, materials})
    if (each && model.stages.empty())
      each->fail("given in the first stage", "a later one: the scene says what is first");
  if (joints) rock.joints = changed(*joints, joints_in(model, model.stages.size()));
  if (!materials) return rock;
  rock.materials = changed(*materials, materials_in(model, model.stages.size()));
  check_growth(*materials, rock.materials, model);
  return rock;
}

}  // namespace dda
