#include "engine/model/rock_change.h"

#include <algorithm>
#include <utility>

#include "engine/model/model.h"

namespace dda {
namespace {

template <typename Table>
const Table& latest(const Model& model, std::size_t stage, Table RockOfStage::*table, const Table& otherwise) {
  for (std::size_t i = std::min(stage + 1, model.stages.size()); i > 0; --i)
    if (!(model.stages[i - 1].rock.*table).empty()) return model.stages[i - 1].rock.*table;
  return otherwise;
}

}  // namespace

const std::vector<Material>& materials_in(const Model& model, std::size_t stage) {
  return latest(model, stage, &RockOfStage::materials, model.materials);
}

const std::vector<JointMaterial>& joints_in(const Model& model, std::size_t stage) {
  return latest(model, stage, &RockOfStage::joints, model.joints);
}

bool have_same_moduli(const Material& a, const Material& b) { return a.young == b.young && a.poisson == b.poisson; }

bool have_same_strength(const JointMaterial& a, const JointMaterial& b) {
  return a.friction_angle == b.friction_angle && a.cohesion == b.cohesion && a.tensile_strength == b.tensile_strength &&
         a.residual_friction_angle == b.residual_friction_angle && a.residual_cohesion == b.residual_cohesion;
}

bool have_same_density(const Material& a, const Material& b) { return a.density == b.density; }

bool have_same_springs(const JointMaterial& a, const JointMaterial& b) {
  return a.normal_spring == b.normal_spring && a.spring_over_young == b.spring_over_young &&
         a.shear_to_normal == b.shear_to_normal && a.normal_stiffness == b.normal_stiffness &&
         a.shear_stiffness == b.shear_stiffness && a.automatic_stiffness == b.automatic_stiffness &&
         a.contact_damping == b.contact_damping;
}

bool springs_go_by_length(const JointMaterial& joint) {
  return joint.normal_stiffness > 0 || joint.automatic_stiffness;
}

bool changes_springs(const Model& model) {
  for (std::size_t i = 1; i < model.stages.size(); ++i)
    if (!std::ranges::equal(joints_in(model, i - 1), joints_in(model, i), have_same_springs)) return true;
  return false;
}

void keep_rock_at_start(Model& model) {
  if (model.stages.empty()) return;
  RockOfStage& first = model.stages.front().rock;
  if (changes_materials(model) && first.materials.empty()) first.materials = model.materials;
  if (changes_joints(model) && first.joints.empty()) first.joints = model.joints;
}

Model with_rock_at_start(Model model) {
  model.materials = std::vector(materials_in(model, 0));
  model.joints = std::vector(joints_in(model, 0));
  return model;
}

}  // namespace dda
