#include "dda/scene/scheme.h"

namespace dda {
namespace {

constexpr double contact_rho_inf = 0.8;  // damps the ringing that changing contacts excite in the trapezoidal rule

Integrator accurate_integrator(Kinematics kinematics, bool all_bonded) {
  const bool contacts_change = !all_bonded && kinematics == Kinematics::finite;
  return contacts_change ? generalized_alpha_integrator(contact_rho_inf) : trapezoidal_integrator();
}

}  // namespace

JointMaterial preset_joint(const Scheme& scheme) {
  JointMaterial joint;
  if (scheme.name == SchemeName::thesis) {
    joint.law = InterfaceLaw::classical;
    joint.spring_over_young = 10;
    joint.shear_to_normal = 0.4;
  }
  return joint;
}

Stage preset_stage(const Scheme& scheme, Kinematics kinematics, bool all_bonded) {
  Stage stage;
  stage.kinematics = kinematics;
  stage.integrator =
      scheme.name == SchemeName::thesis ? thesis_integrator() : accurate_integrator(kinematics, all_bonded);
  return stage;
}

}  // namespace dda
