#include "engine/safety/reduced_strength.h"

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

}  // namespace

Model with_strength_over(double factor, Model model) {
  weaken_all(factor, model.joints);
  for (Stage& stage : model.stages) weaken_all(factor, stage.rock.joints);
  return model;
}

}  // namespace dda
