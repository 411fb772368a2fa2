#include "engine/safety/reduced_strength.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dda {
namespace {

double reduced_angle(double angle, double factor) { return std::atan(std::tan(angle) / factor); }

void weaken(JointMaterial& joint, double factor) {
  joint.friction_angle = reduced_angle(joint.friction_angle, factor);
  if (joint.residual_friction_angle)
    joint.residual_friction_angle = reduced_angle(*joint.residual_friction_angle, factor);
  joint.dilation_angle = reduced_angle(joint.dilation_angle, factor);
  joint.cohesion /= factor;
  joint.residual_cohesion /= factor;
  joint.tensile_strength /= factor;
}

void weaken_all(double factor, std::vector<JointMaterial>& joints) {
  for (JointMaterial& joint : joints)
    if (!joint.bonded) weaken(joint, factor);
}

bool is_brittle(const JointMaterial& joint) {
  const double residual = joint.residual_friction_angle.value_or(joint.friction_angle);
  return !joint.bonded && (joint.residual_cohesion < joint.cohesion || residual < joint.friction_angle);
}

bool has_brittle(const std::vector<JointMaterial>& joints) { return std::ranges::any_of(joints, is_brittle); }

void keep_strength(std::vector<JointMaterial>& joints) {
  for (JointMaterial& joint : joints) {
    joint.residual_cohesion = joint.cohesion;
    joint.residual_friction_angle.reset();
  }
}

}  // namespace

Model with_strength_over(double factor, Model model) {
  weaken_all(factor, model.joints);
  for (Stage& stage : model.stages) weaken_all(factor, stage.rock.joints);
  return model;
}

bool loses_strength(const Model& model) {
  return has_brittle(model.joints) ||
         std::ranges::any_of(model.stages, [](const Stage& stage) { return has_brittle(stage.rock.joints); });
}

Model with_strength_kept(Model model) {
  keep_strength(model.joints);
  for (Stage& stage : model.stages) keep_strength(stage.rock.joints);
  return model;
}

}  // namespace dda
