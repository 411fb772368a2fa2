// Stages that change the rock: `"joints"` and `"materials"` of a stage, by the names of the scene.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/check_parts.h"
#include "engine/model/rock_change.h"
#include "engine/scene/places.h"
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

constexpr std::array strengths = {"friction_angle", "cohesion", "tensile_strength", "residual_friction_angle",
                                  "residual_cohesion"};
constexpr std::array springs_of_contacts = {"normal_spring", "spring_over_young"};
constexpr std::array springs_by_area = {"normal_stiffness", "shear_stiffness"};

template <typename Keys>
std::optional<Field> first_of(const Keys& keys, const Field& field) {
  for (const char* key : keys)
    if (field.has(key)) return field.at(key);
  return std::nullopt;
}

void read_strength(const Field& field, JointMaterial& joint) {
  const auto given = first_of(strengths, field);
  if (!given) return;
  if (joint.bonded) given->fail("to be left out of a bonded joint, in which nothing parts or slides");
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

void read_springs_of_contacts(const Field& field, JointMaterial& joint) {
  const auto given = first_of(springs_of_contacts, field);
  if (given && springs_go_by_length(joint))
    given->fail("to be left out: this joint has a stiffness per area, which only normal_stiffness changes");
  if (const auto spring = field.find("normal_spring")) {
    refuse(field, {"spring_over_young"}, "beside normal_spring");
    joint.normal_spring = spring->positive(Dimension::force_per_length);
  }
  if (const auto spring = field.find("spring_over_young")) {
    joint.spring_over_young = spring->positive(Dimension::dimensionless);
    joint.normal_spring = 0;
  }
}

void read_normal_stiffness(const Field& normal, JointMaterial& joint) {
  joint.automatic_stiffness = normal.is_text() && normal.text() == "auto";
  if (joint.automatic_stiffness) {
    joint.normal_stiffness = joint.shear_stiffness = 0;
    return;
  }
  if (joint.law != InterfaceLaw::classical && joint.law != InterfaceLaw::projected)
    normal.fail("\"auto\", or to be left out unless law is \"classical\" or \"projected\"");
  joint.normal_stiffness = normal.positive(Dimension::stiffness_per_area);
}

void read_springs_by_area(const Field& field, JointMaterial& joint) {
  const auto given = first_of(springs_by_area, field);
  if (given && !springs_go_by_length(joint))
    given->fail(
        "to be left out: this joint has springs for each contact, which normal_spring and spring_over_young change");
  if (const auto normal = field.find("normal_stiffness")) read_normal_stiffness(*normal, joint);
  const auto shear = field.find("shear_stiffness");
  if (!shear) return;
  if (joint.automatic_stiffness) shear->fail("to be left out unless normal_stiffness is given in Pa/m");
  refuse(field, {"shear_to_normal"}, "beside shear_stiffness");
  joint.shear_stiffness = shear->positive(Dimension::stiffness_per_area);
}

void read_shear_to_normal(const Field& field, JointMaterial& joint) {
  const auto ratio = field.find("shear_to_normal");
  if (!ratio) return;
  const double before = joint.shear_to_normal;
  joint.shear_to_normal = ratio->not_negative(Dimension::dimensionless);
  if (joint.shear_to_normal == 0 && (before > 0 || joint.shear_stiffness > 0))
    ratio->fail("above 0, as before: what the joint carries would be lost");
  joint.shear_stiffness = 0;
}

// A projected joint has a compliance beside that of its blocks, where it was given one.
void check_projected(const Field& field, const Field& given, const JointMaterial& joint) {
  if (joint.law != InterfaceLaw::projected) return;
  refuse(field, {"normal_spring", "spring_over_young", "contact_damping"}, "with the projected law");
  if (joint.normal_stiffness == 0)
    given.fail(
        "to be left out of a projected joint that was given no normal_stiffness, and gives way by its blocks alone");
  const auto normal = field.find("normal_stiffness");
  if (normal && normal->is_text() && normal->text() == "auto")
    normal->fail("in Pa/m, or to be left out with the projected law");
}

// Springs, where the joint has any: a closed consistent joint gives way by its blocks alone.
void read_springs(const Field& field, JointMaterial& joint) {
  constexpr std::array keys = {"normal_spring",   "spring_over_young", "normal_stiffness",
                               "shear_stiffness", "shear_to_normal",   "contact_damping"};
  const auto given = first_of(keys, field);
  if (!given) return;
  check_projected(field, *given, joint);
  if (joint.bonded && joint.law != InterfaceLaw::classical)
    given->fail("to be left out of a bonded joint unless law is \"classical\": others have no springs");
  read_springs_of_contacts(field, joint);
  read_springs_by_area(field, joint);
  read_shear_to_normal(field, joint);
  joint.contact_damping = value_or(field, "contact_damping", joint.contact_damping,
                                   [](const Field& f) { return f.not_negative(Dimension::dimensionless); });
}

void read_change(const Field& field, JointMaterial& joint) {
  read_strength(field, joint);
  read_springs(field, joint);
}

void read_change(const Field& field, Material& material) {
  if (const auto density = field.find("density")) material.density = density->positive(Dimension::mass_density);
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
