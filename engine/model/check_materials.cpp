#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <vector>

#include "engine/core/error.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"

namespace dda::model_checks {
namespace {

// Outside this range the elasticity matrix is not positive definite.
void check_poisson(const Item& item, const Material& material) {
  const bool strain = material.plane == PlaneState::strain;
  const bool low_enough = strain ? material.poisson < 0.5 : material.poisson <= 0.5;
  if (material.poisson > -1 && low_enough) return;
  item.fail("Poisson's ratio", fmt::format("{}", material.poisson),
            strain ? "a number above -1 and below 0.5 (plane strain)" : "a number above -1 and at most 0.5");
}

// What is left after failure: not more than before, and no dilation that would make sliding a source of energy.
void check_failed_joint(const Item& item, const JointMaterial& joint) {
  const double residual_friction = joint.residual_friction_angle.value_or(joint.friction_angle);
  item.within("residual friction angle", residual_friction, 0, joint.friction_angle);
  item.within("residual cohesion", joint.residual_cohesion, 0, joint.cohesion);
  item.within("dilation angle", joint.dilation_angle, 0, residual_friction);
  if (joint.zero_dilation_slip > 0) return;  // infinity says that there is no end
  item.fail("zero-dilation slip", fmt::format("{} m", joint.zero_dilation_slip), "a length above 0");
}

void check_joint(const Item& item, const JointMaterial& joint) {
  constexpr double right_angle = std::numbers::pi / 2;
  item.not_negative("friction angle", joint.friction_angle);
  if (joint.friction_angle >= right_angle) {
    item.fail("friction angle", fmt::format("{} rad", joint.friction_angle), "an angle below 90 deg");
  }
  item.not_negative("cohesion", joint.cohesion);
  item.not_negative("tensile strength", joint.tensile_strength);
  check_failed_joint(item, joint);
  item.not_negative("normal spring", joint.normal_spring);
  item.not_negative("normal stiffness", joint.normal_stiffness);
  item.not_negative("shear stiffness", joint.shear_stiffness);
  item.not_negative("spring over Young's modulus", joint.spring_over_young);
  item.not_negative("shear to normal spring", joint.shear_to_normal);
  item.not_negative("contact damping", joint.contact_damping);
  item.not_negative("stabilisation", stabilisation_of(joint));
  if (joint.penalty > 1 && joint.penalty <= std::numeric_limits<double>::max()) return;
  item.fail("penalty", fmt::format("{}", joint.penalty), "a finite number above 1");
}

void check_joint_pairs(const Model& model) {
  const Item item("joint_of_block_pair", 0);
  for (const auto& [pair, joint] : model.joint_of_block_pair) {
    item.index("block", pair.first, model.blocks.size());
    item.index("block", pair.second, model.blocks.size());
    item.index("joint", joint, model.joints.size());
    if (pair.first <= pair.second) continue;  // of a block with itself: contact/tied_sides.h
    item.fail("pair", fmt::format("({}, {})", pair.first, pair.second), "the smaller index first");
  }
}

void check_joint_lines(const Model& model) {
  for (std::size_t i = 0; i < model.joint_lines.size(); ++i) {
    const JointLine& line = model.joint_lines[i];
    const Item item("joint_lines", i);
    item.finite("from", line.from);
    item.finite("to", line.to);
    item.index("joint", line.joint, model.joints.size());
    if (line.from != line.to) continue;
    item.fail("to", fmt::format("({}, {}) m, where it begins", line.to.x(), line.to.y()), "a line of some length");
  }
}

// Beyond what is rigid beside any rock, and far from where squares of moduli overflow.
void check_modulus(const Item& item, const Material& material) {
  constexpr double most = 1e30;  // Pa
  if (material.young > most) item.fail("Young's modulus", fmt::format("{:g} Pa", material.young), "at most 1e30 Pa");
}

}  // namespace

void check_materials(const std::vector<Material>& materials) {
  if (materials.empty()) throw InputError("", "materials", "empty", "at least one material");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const Material& material = materials[i];
    const Item item("materials", i, material.name);
    item.positive("density", material.density);
    item.positive("Young's modulus", material.young);
    check_poisson(item, material);
    check_modulus(item, material);
  }
}

void check_strengths(const std::vector<JointMaterial>& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i) check_joint(Item("joints", i, joints[i].name), joints[i]);
}

void check_joints(const Model& model) {
  check_strengths(model.joints);
  check_joint_pairs(model);
  check_joint_lines(model);
}

}  // namespace dda::model_checks
